#include "clients/evaluate/floor/study.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

#include "clients/evaluate/files.hpp"
#include "clients/evaluate/floor/rows.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate::floor {
namespace {

class StudyOfFloors : public testing::Test {
 protected:
  StudyOfFloors() {
    options.site = WEFT_SITES "/demo.toml";
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
  Study study() const {
    return {WEFT_VERSION, sha256_of(read_text(WEFT_SITES "/demo.toml", "").value()),
            sha256_of(read_text(WEFT_SITES "/demo/r1.line", "").value()), "", options.metres};
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
  EXPECT_NE(progress.str().find("2 rows to measure, 0 of them"), std::string::npos) << progress.str();
  EXPECT_TRUE(std::filesystem::is_empty(options.out));
}

TEST_F(StudyOfFloors, RowsThatAreThereAreNotMeasuredAgain) {
  std::filesystem::create_directories(options.out);
  Rows rows;
  rows[{"epoxy", kMapping, 5}].speed_percent = 0.4;
  rows[{"epoxy", "same", 5}].goal_mm = 7.0;
  ASSERT_TRUE(write_rows(options.out, study(), rows, options.seeds).has_value());
  const Result<Ended> ended = run();
  ASSERT_TRUE(ended.has_value()) << ended.error().message;
  EXPECT_EQ(*ended, Ended::complete);
  EXPECT_NE(progress.str().find("2 of them are there already"), std::string::npos) << progress.str();
  EXPECT_NE(out.str().find("| epoxy | same, median"), std::string::npos) << out.str();
  EXPECT_TRUE(std::filesystem::exists(options.out / "floor.csv"));
}

TEST_F(StudyOfFloors, AShortWayIsTaughtAndRepeated) {
  options.metres = 5.0;
  samples = std::numeric_limits<int>::max();
  const Result<Ended> ended = run();
  ASSERT_TRUE(ended.has_value()) << ended.error().message;
  const auto rows = read_rows(options.out, study());
  ASSERT_TRUE(rows.has_value()) << rows.error().message;
  const Score& mapping = rows->at({"epoxy", kMapping, 5});
  EXPECT_GT(mapping.metres, 10.0);
  EXPECT_LT(mapping.speed_percent, 5.0);
  EXPECT_LT(mapping.speed_fast_percent, 10.0);
  const Score& repeated = rows->at({"epoxy", "same", 5});
  EXPECT_EQ(repeated.arrived, 1.0);
  EXPECT_GT(repeated.metres, 4.0);
  EXPECT_LT(repeated.goal_mm, 60.0);
  EXPECT_LT(repeated.lateral_worst_mm, 100.0);
  EXPECT_EQ(repeated.wrong_fixes, 0.0);
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
