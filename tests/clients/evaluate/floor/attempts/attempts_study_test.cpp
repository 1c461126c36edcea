#include "clients/evaluate/floor/attempts/attempts_study.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>
#include <sstream>

#include "clients/evaluate/floor/attempts/attempt_rows.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate::floor {
namespace {

class StudyOfAttempts : public testing::Test {
 protected:
  StudyOfAttempts() {
    options.site = folder.path() / "small.toml";
    options.along = folder.path() / "small.line";
    // A hall without racks, seen by a small camera: quicker.
    std::ofstream(options.site) << "[floor]\nx_min = 0.0\ny_min = 0.0\nx_max = 20.0\ny_max = 12.8\n"
                                   "[camera]\nwidth_px = 376\nheight_px = 240\nfocal_px = 230\nfps = 10\n"
                                   "[[robot]]\nname = \"r1\"\nx = 2.0\ny = 6.4\n";
    std::ofstream(options.along) << "2 6.4\n4 6.4\n9 6.5\n";
    options.out = folder.path() / "out";
    options.kind = "asphalt";
    options.light = "same";
    options.metres = 5.0;
    options.attempts = 60;
  }
  Result<Ended> run() {
    return study_attempts(options, {out, progress, [] { return 0.0; }, [this] { return --samples < 0; }});
  }

  storage::TemporaryDirectory folder;
  AttemptsOptions options;
  int samples = std::numeric_limits<int>::max();  ///< until it is asked to stop
  std::ostringstream out, progress;
};

TEST_F(StudyOfAttempts, ManyAreMadeNoneIsWrongAndTheyAreKept) {
  const Result<Ended> ended = run();
  ASSERT_TRUE(ended.has_value()) << ended.error().message;
  EXPECT_EQ(*ended, Ended::complete);
  EXPECT_NE(progress.str().find("1 of 1 (asphalt, same, seed 1: "), std::string::npos) << progress.str();
  EXPECT_NE(out.str().find("| elsewhere"), std::string::npos) << out.str();
  EXPECT_TRUE(std::filesystem::exists(options.out / "attempts.csv"));
  EXPECT_TRUE(std::filesystem::exists(options.out / "floor-attempts.png"));

  // The same again drives nothing.
  samples = 0;
  const Result<Ended> again = run();
  ASSERT_TRUE(again.has_value()) << again.error().message;
  EXPECT_EQ(*again, Ended::complete);
  EXPECT_NE(progress.str().find("1 rows to measure, 1 of them"), std::string::npos) << progress.str();
}

TEST_F(StudyOfAttempts, StopsWhenAsked) {
  samples = 3;
  const Result<Ended> ended = run();
  ASSERT_TRUE(ended.has_value()) << ended.error().message;
  EXPECT_EQ(*ended, Ended::stopped);
  EXPECT_FALSE(std::filesystem::exists(options.out / "attempts.json"));
}

TEST_F(StudyOfAttempts, WhatIsWrongIsNamed) {
  options.kind = "cheese";
  const Result<Ended> ended = run();
  ASSERT_FALSE(ended.has_value());
  EXPECT_NE(ended.error().message.find("--kind: no floor \"cheese\""), std::string::npos) << ended.error().message;
}

}  // namespace
}  // namespace weft::evaluate::floor
