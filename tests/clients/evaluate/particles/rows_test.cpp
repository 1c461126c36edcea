#include "clients/evaluate/particles/rows.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "clients/evaluate/files.hpp"

namespace weft::evaluate::particles {
namespace {

TrialRow row_of(std::uint64_t seed, double mean_m) {
  TrialRow row;
  row.seed = seed;
  row.located = 100;
  row.mean_m = mean_m;
  row.p95_m = 2.0 * mean_m;
  return row;
}

TEST(ParticleRows, ComeBackAsTheyWereWritten) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "particle-rows.json";
  TrialRow row = row_of(2, 0.031);
  row.found_after = std::numeric_limits<double>::quiet_NaN();
  row.is_lost = true;
  const nlohmann::json study = {{"log", "a.log"}};
  ASSERT_TRUE(write_rows(file, study, {row}));
  const Result<std::vector<TrialRow>> rows = read_rows(file, study);
  ASSERT_TRUE(rows) << rows.error().message;
  ASSERT_EQ(rows->size(), 1U);
  EXPECT_EQ(rows->front().mean_m, row.mean_m);
  EXPECT_TRUE(std::isnan(rows->front().found_after));
  EXPECT_TRUE(rows->front().is_lost);
  const Result<std::vector<TrialRow>> others = read_rows(file, {{"log", "b.log"}});
  ASSERT_FALSE(others);
  EXPECT_EQ(others.error().code, ErrorCode::conflict);
  std::filesystem::remove(file);
}

TEST(ParticleRows, WhatIsAskedIsNamedByLogAndAlpha) {
  EXPECT_EQ(asked_of("freiburg-079-corrected.log.gz", 0.2, false).mean_m, 0.07);
  EXPECT_EQ(asked_of("freiburg-079-corrected.log.gz", 0.1, false).mean_m, 0.0);
  EXPECT_EQ(asked_of("intel-corrected.log.gz", 0.2, false).mean_m, 0.18);
  EXPECT_EQ(asked_of("intel-corrected.log.gz", 0.2, true).found_after, 40.0);
}

TEST(ParticleRows, MeansAreHeldAgainstWhatIsAsked) {
  const Asked asked{0.07, 0.16, 0.0};
  EXPECT_TRUE(judge({row_of(1, 0.06), row_of(2, 0.078)}, asked, false).is_met);
  const Judged missed = judge({row_of(1, 0.06), row_of(2, 0.09)}, asked, false);
  EXPECT_FALSE(missed.is_met);
  EXPECT_NE(missed.table.find("NOT MET"), std::string::npos);
  EXPECT_FALSE(judge({}, asked, false).is_met);
}

TEST(ParticleRows, ADocumentHoldsRowsBoundsAndVerdict) {
  TrialRow row = row_of(3, 0.06);
  row.found_after = std::numeric_limits<double>::quiet_NaN();
  const nlohmann::json document = judged_document({{"log", "a.log"}}, {row}, {0.07, 0.0, 0.0}, true);
  EXPECT_EQ(document.at("study").at("log"), "a.log");
  EXPECT_EQ(document.at("rows").at(0).at("mean_m"), 0.06);
  EXPECT_TRUE(document.at("rows").at(0).at("found_after").is_null());
  EXPECT_EQ(document.at("asked").at("mean_m"), 0.07);
  EXPECT_TRUE(document.at("asked").at("p95_m").is_null()) << "nothing is asked of it";
  EXPECT_EQ(document.at("is_met"), true);
}

TEST(ParticleRows, ALostSeedOrOneThatIsNotFoundInTimeMisses) {
  TrialRow lost = row_of(1, 0.01);
  lost.is_lost = true;
  EXPECT_FALSE(judge({lost}, {}, false).is_met);
  TrialRow found = row_of(1, 0.01);
  found.found_after = 40.0;
  EXPECT_TRUE(judge({found}, {0.0, 0.0, 40.0}, true).is_met);
  found.found_after = 41.0;
  EXPECT_FALSE(judge({found}, {0.0, 0.0, 40.0}, true).is_met);
  found.found_after = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(judge({found}, {0.0, 0.0, 40.0}, true).is_met);
}

}  // namespace
}  // namespace weft::evaluate::particles
