#include "clients/evaluate/disturbances/study.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "clients/evaluate/disturbances/rows.hpp"
#include "clients/evaluate/disturbances/switches.hpp"
#include "core/network/codec.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate {
namespace {

using storage::TemporaryDirectory;

class StudyOfDisturbances : public testing::Test {
 protected:
  StudyOfDisturbances() {
    options.site = WEFT_SITES "/demo.toml";
    options.out = folder.path() / "out";
  }
  Result<Ended> run() {
    return study_disturbances(options, {out, progress, [] { return 0.0; }, [this] { return --samples < 0; }});
  }
  std::string refusal() {
    const Result<Ended> ended = run();
    return ended ? "not refused" : ended.error().message;
  }
  static std::string hash_of(const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    return to_string(hash_bytes({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
  }

  TemporaryDirectory folder;
  DisturbancesOptions options;
  int samples = 0;  ///< until it is asked to stop
  std::ostringstream out, progress;
};

TEST_F(StudyOfDisturbances, StopsWhenAskedAndLeavesNoTruthBehind) {
  samples = 3;
  const Result<Ended> ended = run();
  ASSERT_TRUE(ended.has_value()) << ended.error().message;
  EXPECT_EQ(*ended, Ended::stopped);
  EXPECT_NE(progress.str().find("40 rows to measure, 0 of them"), std::string::npos) << progress.str();
  EXPECT_TRUE(std::filesystem::is_empty(options.out));
}

TEST_F(StudyOfDisturbances, RowsThatAreThereAreNotMeasuredAgain) {
  std::filesystem::create_directories(options.out);
  Rows rows;
  for (const Variant& variant : variants_of({})) {
    rows[{name_of(variant), 5}] = {3.0, 40.0, 0.3, 4.0, 9.0, 0.1, 97.0, 0.0, 0.5};
  }
  const Study study{WEFT_VERSION, hash_of(WEFT_SITES "/demo.toml"), hash_of(WEFT_SITES "/demo/r1.line"), 12.0};
  ASSERT_TRUE(write_rows(options.out, study, rows).has_value());
  options.seeds = {5, 5};
  const Result<Ended> ended = run();
  ASSERT_TRUE(ended.has_value()) << ended.error().message;
  EXPECT_EQ(*ended, Ended::complete);
  EXPECT_NE(progress.str().find("40 of them are there already"), std::string::npos) << progress.str();
  EXPECT_NE(out.str().find("| without noise "), std::string::npos);
  EXPECT_GT(std::filesystem::file_size(options.out / "disturbances.png"), 10'000U);
  EXPECT_GT(std::filesystem::file_size(options.out / "disturbances.csv"), 1'000U);
}

TEST_F(StudyOfDisturbances, OnlyTheRowsThatAreAskedFor) {
  std::filesystem::create_directories(options.out);
  Rows rows;
  for (const char* name : {"all", "only blur", "with rolling shutter 20 ms", "only rolling shutter 20 ms"})
    rows[{name, 5}] = {3.0, 40.0, 0.3, 4.0, 9.0, 0.1, 97.0, 0.0, 0.5};
  const Study study{WEFT_VERSION, hash_of(WEFT_SITES "/demo.toml"), hash_of(WEFT_SITES "/demo/r1.line"), 12.0};
  ASSERT_TRUE(write_rows(options.out, study, rows).has_value());
  options.seeds = {5, 5};
  options.only = {"rolling shutter 20 ms", "all"};
  const Result<Ended> ended = run();
  ASSERT_TRUE(ended.has_value()) << ended.error().message;
  EXPECT_EQ(*ended, Ended::complete);
  EXPECT_NE(progress.str().find("3 rows to measure, 3 of them"), std::string::npos) << progress.str();
  EXPECT_NE(out.str().find("| with rolling shutter 20 ms "), std::string::npos);
  EXPECT_EQ(out.str().find("| only blur "), std::string::npos);
  std::ifstream csv(options.out / "disturbances.csv");
  const std::string text{std::istreambuf_iterator<char>(csv), {}};
  EXPECT_NE(text.find("\"only blur\",5"), std::string::npos) << "rows of other calls stay";
  options.only = {"rolling"};
  EXPECT_NE(refusal().find("--only: there is no 'rolling'"), std::string::npos) << refusal();
}

TEST_F(StudyOfDisturbances, WhatIsMissingOrWrongIsNamed) {
  options.site = "none.toml";
  EXPECT_NE(refusal().find("none.toml: no such site file"), std::string::npos) << refusal();
  const std::string wrong = (folder.path() / "wrong.toml").string();
  std::ofstream(wrong) << "[floor]\nx_min = 0\ny_min = 0\nx_max = 9\ny_max = 5000\nmaterail = \"mud\"\n";
  options.site = wrong;
  EXPECT_NE(refusal().find("wrong.toml:5: floor.y_max"), std::string::npos) << refusal();
  EXPECT_NE(refusal().find("wrong.toml:6: floor.materail"), std::string::npos) << refusal();
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
}  // namespace weft::evaluate
