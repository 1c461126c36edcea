#include "clients/evaluate/bearing/rows.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <fstream>

#include "clients/evaluate/bearing/bounds.hpp"
#include "clients/evaluate/bearing/trials.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate::bearing {
namespace {

using testing::HasSubstr;

const Study kStudy{"1.2.3", "abc"};

Score score_of(double error_m, std::size_t loops) {
  Score score;
  for (std::size_t i = 0; i < loops; ++i) score.after_loop_m.push_back(error_m);
  score.metres = 10.0 * static_cast<double>(loops);
  score.landmark_m = 2.5;
  return score;
}

const Judged& judged_of(const std::vector<Judged>& all, const std::string& name) {
  for (const Judged& judged : all) {
    if (name_of(*judged.bound) == name) return judged;
  }
  ADD_FAILURE() << name;
  return all.front();
}

TEST(BearingRows, AreReadAsTheyWereWritten) {
  const storage::TemporaryDirectory folder;
  Rows rows;
  rows[{"oval", 3}] = score_of(0.02, 20);
  rows[{"oval", 3}].ended = "lost";
  ASSERT_TRUE(write_rows(folder.path(), kStudy, rows, {1, 3}));
  const Result<Rows> read = read_rows(folder.path(), kStudy);
  ASSERT_TRUE(read) << read.error().message;
  const Score& score = read->at({"oval", 3});
  EXPECT_EQ(score.after_loop_m, std::vector<double>(20, 0.02));
  EXPECT_EQ(score.ended, "lost");
  EXPECT_EQ(score.landmark_m, 2.5);
  EXPECT_TRUE(std::isnan(score.band_m));
}

TEST(BearingRows, OtherScenesAndDamageAreRefused) {
  const storage::TemporaryDirectory folder;
  ASSERT_TRUE(write_rows(folder.path(), kStudy, {}, {1, 1}));
  const auto other = read_rows(folder.path(), {"1.2.3", "def"});
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().code, ErrorCode::conflict);
  EXPECT_THAT(other.error().message, HasSubstr("scenes_sha256"));
  std::ofstream(folder.path() / "bearing.json") << "{\"study\"";
  EXPECT_EQ(read_rows(folder.path(), kStudy).error().code, ErrorCode::corrupt);
}

TEST(BearingBounds, AreOfMedianAndWorst) {
  Rows rows;
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
    rows[{"oval", seed}] = score_of(0.01 * static_cast<double>(seed), 20);
  const auto judged = judge(rows, {1, 3});
  EXPECT_TRUE(judged_of(judged, "oval, after 2 loops").met);
  EXPECT_NEAR(judged_of(judged, "oval, after 20 loops").median, 0.02, 1e-12);
  rows[{"oval", 4}] = score_of(0.06, 20);
  EXPECT_FALSE(judged_of(judge(rows, {1, 4}), "oval, after 20 loops").met) << "the worst may be 0.05 m";
}

TEST(BearingBounds, OneThatWasMeasuredAndDoesNotHoldIsMissed) {
  Rows rows;
  EXPECT_FALSE(is_any_missed(judge(rows, {1, 1}))) << "nothing was measured";
  rows[{"oval", 1}] = score_of(0.01, 20);
  EXPECT_FALSE(is_any_missed(judge(rows, {1, 1})));
  rows[{"oval", 1}] = score_of(0.01, 5);
  EXPECT_TRUE(is_any_missed(judge(rows, {1, 1}))) << "it was to come round 20 times";
}

TEST(BearingBounds, WhatThePaperShowsToFailIsToFail) {
  Rows rows;
  rows[{"oval-profile-only", 1}] = score_of(2.0, 5);
  rows[{"oval-profile-only", 2}] = Score{};  // off the way in its first loop
  rows[{"corners-vision-only", 1}] = Score{};
  const auto astray = "oval-profile-only, goes astray by at least, a loop";
  EXPECT_TRUE(judged_of(judge(rows, {1, 2}), astray).met);
  EXPECT_NEAR(judged_of(judge(rows, {1, 2}), astray).worst, 0.4, 1e-12);
  EXPECT_TRUE(judged_of(judge(rows, {1, 2}), "corners-vision-only, loops before it is lost").met);
  rows[{"oval-profile-only", 3}] = score_of(0.05, 5);
  rows[{"corners-vision-only", 2}] = score_of(0.5, 2);
  EXPECT_FALSE(judged_of(judge(rows, {1, 3}), astray).met) << "it has stayed on its way";
  EXPECT_FALSE(judged_of(judge(rows, {1, 3}), "corners-vision-only, loops before it is lost").met);
}

TEST(BearingBounds, TheFirstLoopIsHeldAgainstTheModel) {
  Rows rows;
  rows[{"oval-as-published", 1}] = score_of(0.1, 20);
  const auto beside = "oval-as-published, first loop beside the model";
  EXPECT_FALSE(judged_of(judge(rows, {1, 1}), beside).met) << "without a band nothing is shown";
  rows[{"oval-as-published", 1}].band_m = 0.12;
  EXPECT_TRUE(judged_of(judge(rows, {1, 1}), beside).met);
}

TEST(BearingBounds, WhoDoesNotComeSoFarIsTheWorst) {
  Rows rows;
  rows[{"oval", 1}] = score_of(0.01, 20);
  rows[{"oval", 2}] = score_of(0.01, 20);
  rows[{"oval", 3}] = score_of(0.01, 5);
  const auto judged = judge(rows, {1, 3});
  EXPECT_TRUE(judged_of(judged, "oval, after 2 loops").met);
  EXPECT_FALSE(judged_of(judged, "oval, after 20 loops").met);
  EXPECT_FALSE(judged_of(judged, "yard-day, after 7 loops").met) << "not measured is not met";
}

TEST(BearingTrials, EveryBoundIsOfATrialThatDrivesSoFar) {
  for (const Bound& bound : bounds()) {
    bool is_there = false;
    for (const Trial& trial : trials())
      is_there = is_there || (trial.name == bound.trial && trial.loops >= bound.loops);
    EXPECT_TRUE(is_there) << name_of(bound);
  }
}

TEST(BearingTrials, EverySceneIsThere) {
  for (const Trial& trial : trials()) {
    const Result<Scene> scene = read_scene(std::filesystem::path(WEFT_SITES) / "bearing", trial.site, trial.line);
    ASSERT_TRUE(scene) << scene.error().message;
    EXPECT_EQ(scene->site.robots.front().looks, std::vector<agents::Gaze>{agents::Gaze::ahead});
  }
  EXPECT_EQ(read_scene(WEFT_SITES, "nowhere", "nowhere").error().code, ErrorCode::not_found);
}

}  // namespace
}  // namespace weft::evaluate::bearing
