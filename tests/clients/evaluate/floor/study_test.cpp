#include "clients/evaluate/floor/study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "clients/evaluate/files.hpp"
#include "clients/evaluate/floor/figure_runs.hpp"
#include "clients/evaluate/floor/rows.hpp"
#include "tests/clients/evaluate/floor/driven_trace.hpp"
#include "tests/clients/evaluate/floor/small_hall.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate::floor {
namespace {

const std::vector<const char*> kRates = {"600-in-10s", "300-in-10s", "150-in-10s", "75-in-10s"};

class StudyOfFloors : public testing::Test {
 protected:
  StudyOfFloors() {
    options.site = WEFT_SITES "/demo.toml";
    options.along = WEFT_SITES "/demo/r1.line";
    options.out = folder.path() / "out";
    options.kind = "epoxy";
    options.light = "same";
    options.seeds = {5, 5};
  }
  Result<Ended> run() {
    return study_floor(options, {out, progress, [] { return 0.0; }, [this] { return --samples < 0; }});
  }
  std::string refusal() {
    const Result<Ended> ended = run();
    return ended ? "not refused" : ended.error().message;
  }
  /// Fills the shelf with runs that nobody drove.
  void fill_shelf(const std::vector<const char*>& runs) const {
    const Shelf shelf{options.out / "series", stamp_of(study()), options.kind, options.seeds.first};
    for (const char* const run : runs) {
      ASSERT_TRUE(shelf.keep(run, straight_trace(0.5, 2.0)).has_value());
    }
  }
  Study study() const {
    return {WEFT_VERSION, sha256_of(read_text(options.site, "").value()),
            sha256_of(read_text(options.along, "").value()), "", options.metres};
  }

  int pictures() const {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(options.out)) {
      count += entry.path().extension() == ".png" && entry.file_size() > 3'000 ? 1 : 0;
    }
    return count;
  }

  storage::TemporaryDirectory folder;
  FloorOptions options;
  int samples = 0;  ///< until it is asked to stop
  std::ostringstream out, progress;
};

TEST_F(StudyOfFloors, StopsWhenAskedAndLeavesNoTruthBehind) {
  samples = 3;
  const Result<Ended> ended = run();
  ASSERT_TRUE(ended.has_value()) << ended.error().message;
  EXPECT_EQ(*ended, Ended::stopped);
  EXPECT_NE(progress.str().find("3 rows to measure, 0 of them"), std::string::npos) << progress.str();
  EXPECT_TRUE(std::filesystem::is_empty(options.out));
}

TEST_F(StudyOfFloors, RowsThatAreThereAreNotMeasuredAgain) {
  std::filesystem::create_directories(options.out);
  Rows rows;
  rows[{"epoxy", kMapping, 5}].speed_percent = 0.4;
  rows[{"epoxy", "same", 5}].goal_mm = 7.0;
  ASSERT_TRUE(write_rows(options.out, study(), rows, {}).has_value());
  fill_shelf({"taught", "same", "both-taught-1", "both-taught-2", "both-repeated"});
  fill_shelf(kRates);
  const Result<Ended> ended = run();
  ASSERT_TRUE(ended.has_value()) << ended.error().message;
  EXPECT_EQ(*ended, Ended::missed) << "rows without what is promised";
  EXPECT_NE(progress.str().find("3 of them are there already"), std::string::npos) << progress.str();
  EXPECT_NE(out.str().find("| epoxy | same, median"), std::string::npos) << out.str();
  EXPECT_NE(out.str().find("not measured (weft-evaluate floor-relocalise)"), std::string::npos) << out.str();
  EXPECT_TRUE(std::filesystem::exists(options.out / "floor.csv"));
  EXPECT_EQ(pictures(), 10) << progress.str();
}

TEST_F(StudyOfFloors, AShortWayIsTaughtAndRepeated) {
  options.site = folder.path() / "small.toml";
  options.along = folder.path() / "small.line";
  std::ofstream(options.site) << small_hall(20.0, 12.8, 6.4);
  std::ofstream(options.along) << "2 6.4\n4 6.4\n5 6.5\n9 6.5\n";
  options.kind = "asphalt";
  options.metres = 5.0;
  samples = std::numeric_limits<int>::max();
  fill_shelf(kRates);
  const Result<Ended> ended = run();
  ASSERT_TRUE(ended.has_value()) << ended.error().message;
  const auto rows = read_rows(options.out, study());
  ASSERT_TRUE(rows.has_value()) << rows.error().message;
  const Score& mapping = rows->at({"asphalt", kMapping, 5});
  EXPECT_GT(mapping.metres, 9.0);
  EXPECT_LT(mapping.speed_percent, 5.0);
  EXPECT_LT(mapping.speed_fast_percent, 10.0);
  const Score& repeated = rows->at({"asphalt", "same", 5});
  EXPECT_EQ(repeated.arrived, 1.0);
  EXPECT_GT(repeated.metres, 4.0);
  EXPECT_LT(repeated.goal_mm, 60.0);
  EXPECT_LT(repeated.lateral_worst_mm, 100.0);
  EXPECT_EQ(repeated.wrong_fixes, 0.0);
  EXPECT_EQ(pictures(), 10);

  // The same again drives nothing.
  samples = 0;
  progress.str("");
  const Result<Ended> again = run();
  ASSERT_TRUE(again.has_value()) << again.error().message;
  EXPECT_EQ(*again, *ended);
  EXPECT_NE(progress.str().find("3 of them are there already"), std::string::npos) << progress.str();
}

TEST_F(StudyOfFloors, WhatIsMissingOrWrongIsNamed) {
  options.kind = "cheese";
  EXPECT_NE(refusal().find("--kind: no floor \"cheese\"; there are "), std::string::npos) << refusal();
  options.kind.clear();
  options.light = "disco";
  EXPECT_NE(refusal().find("--light: there is no 'disco'; there are same"), std::string::npos) << refusal();
  options.light.clear();
  options.floors = folder.path();
  EXPECT_NE(refusal().find("holds no .png"), std::string::npos) << refusal();
  options.floors.clear();
  options.site = "none.toml";
  EXPECT_NE(refusal().find("none.toml: no such site file"), std::string::npos) << refusal();
  options.site = WEFT_SITES "/demo.toml";
  options.along = "none.line";
  EXPECT_NE(refusal().find("none.line"), std::string::npos);
  options.along.clear();
  options.metres = 500.0;
  EXPECT_NE(refusal().find("500"), std::string::npos);
  options.metres = 12.0;
  std::ofstream(folder.path() / "file") << "in the way";
  options.out = folder.path() / "file" / "out";
  EXPECT_NE(refusal().find("file/out"), std::string::npos) << refusal();
}

}  // namespace
}  // namespace weft::evaluate::floor
