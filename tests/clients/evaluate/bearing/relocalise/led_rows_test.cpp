#include "clients/evaluate/bearing/relocalise/led_rows.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <iterator>

#include "clients/evaluate/bearing/relocalise/led_report.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::evaluate::bearing {
namespace {

using testing::HasSubstr;

const Study kLedStudy{"1.2.3", "abc"};

/// Makes as many as `count`, of which the first `lost` do not find themselves.
std::vector<Led> led(std::size_t count, std::size_t lost) {
  std::vector<Led> all(count);
  for (std::size_t i = 0; i < count; ++i) {
    all[i].site_from_robot = {static_cast<double>(i), 2.0, 0.25};
    if (i < lost) {
      all[i].refused = "another_scene";
    } else {
      all[i].found_m = 0.5;
      all[i].along_m = 0.02;
    }
  }
  return all;
}

Led wrong_one() {
  Led one = led(1, 0).front();
  one.along_m = 1.97;
  return one;
}

const LedGroup& group_of(const std::vector<LedGroup>& groups, const std::string& kind) {
  for (const LedGroup& group : groups)
    if (group.kind->name == kind) return group;
  ADD_FAILURE() << kind;
  return groups.front();
}

TEST(LedRowsFile, IsReadAsItWasWritten) {
  const storage::TemporaryDirectory folder;
  LedRows rows;
  rows.trials[{"one-side", "half", 4}] = led(2, 1);
  rows.trials[{"one-side", "half", 4}].push_back(wrong_one());
  rows.pairs[{"one-side", 4}] = {60, 20, 1};
  ASSERT_TRUE(write_led(folder.path(), kLedStudy, rows));
  const auto back = read_led(folder.path(), kLedStudy);
  ASSERT_TRUE(back) << back.error().message;
  const std::vector<Led>& same = back->trials.at({"one-side", "half", 4});
  ASSERT_EQ(same.size(), 3U);
  EXPECT_FALSE(same[0].found_m);
  EXPECT_EQ(same[0].refused, "another_scene");
  EXPECT_EQ(same[1].found_m, 0.5);
  EXPECT_EQ(same[1].site_from_robot, (Pose2{1.0, 2.0, 0.25}));
  EXPECT_FALSE(is_right(same[2]));
  EXPECT_EQ(back->pairs.at({"one-side", 4}).voted, 20U);
}

TEST(LedRowsFile, OtherSitesAndDamageAreRefused) {
  const storage::TemporaryDirectory folder;
  ASSERT_TRUE(write_led(folder.path(), kLedStudy, {}));
  EXPECT_EQ(read_led(folder.path(), {"1.2.3", "def"}).error().code, ErrorCode::conflict);
  std::ofstream(folder.path() / "relocalise.json") << "[]";
  EXPECT_EQ(read_led(folder.path(), kLedStudy).error().code, ErrorCode::corrupt);
}

TEST(LedRowsFile, HasALineATrialBesideIt) {
  const storage::TemporaryDirectory folder;
  LedRows rows;
  rows.trials[{"one-side", "half", 4}] = led(2, 1);
  ASSERT_TRUE(write_led_csv(folder.path(), rows));
  std::ifstream in(folder.path() / "relocalise.csv");
  const std::string csv{std::istreambuf_iterator<char>(in), {}};
  EXPECT_THAT(csv, HasSubstr("one-side,half,4,0,2,0.25,,,,,,,another_scene\n"));
  EXPECT_THAT(csv, HasSubstr("one-side,half,4,1,2,0.25,0.5,1,0.02,"));
}

TEST(LedJudged, AWrongPlaceIsNotMet) {
  LedRows rows;
  rows.trials[{"other-loads-not-taught", "same", 1}] = led(10, 10);
  EXPECT_TRUE(group_of(judge(rows), "other-loads-not-taught").met) << "no answer is right there";
  rows.trials[{"other-loads-not-taught", "same", 2}] = {wrong_one()};
  const LedGroup group = group_of(judge(rows), "other-loads-not-taught");
  EXPECT_FALSE(group.met);
  EXPECT_EQ(group.wrong, 1U);
  EXPECT_EQ(group.seeds, 2U);
  EXPECT_THAT(tables_of(rows), HasSubstr("NOT MET"));
}

TEST(LedJudged, WhoRefusesEverythingHasNotMetItEither) {
  LedRows rows;
  rows.trials[{"other-loads", "same", 1}] = led(10, 0);
  EXPECT_TRUE(group_of(judge(rows), "other-loads").met);
  rows.trials[{"other-loads", "same", 1}] = led(10, 9);
  EXPECT_FALSE(group_of(judge(rows), "other-loads").met);
}

TEST(LedJudged, RightIsWithinItsBounds) {
  Led one = led(1, 0).front();
  EXPECT_TRUE(is_right(one));
  one.aside_m = 5.0;
  EXPECT_FALSE(is_right(one)) << "another aisle";
  one.aside_m = 1.0;
  EXPECT_TRUE(is_right(one));
  one.turned_rad = 0.2;
  EXPECT_FALSE(is_right(one));
}

}  // namespace
}  // namespace weft::evaluate::bearing
