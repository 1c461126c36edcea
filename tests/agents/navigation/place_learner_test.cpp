#include "agents/navigation/place_learner.hpp"

#include <gtest/gtest.h>

#include <set>

#include "core/network/codec.hpp"
#include "tests/agents/navigation/learning_marks.hpp"
#include "tests/agents/navigation/marks_fleet.hpp"

namespace weft::agents {
namespace {

using test::Course;
using test::NavigatedRobot;

constexpr ExperienceId kRun{1};

/// Arranges places half a metre apart, and a robot that passes them as it is told.
class LearnedPlacesOf : public testing::Test, protected Contents {
 protected:
  LearnedPlacesOf() {
    for (std::uint32_t i = 0; i < 40; ++i) put(i, 100 + i);
  }
  /// Puts a place whose content is unlike that of the others.
  void put(std::uint32_t index, std::uint64_t what) {
    Marks::Sighting sighting;
    sighting.mark = what;
    const Bytes bytes = method_.encode({{sighting}});
    Place place;
    place.id = {kRun, index};
    place.method = "marks";
    place.content = {hash_bytes(bytes), bytes.size()};
    contents_[place.content.hash] = std::make_shared<const Bytes>(bytes);
    window_.places.insert_or_assign(place.id, place);
  }
  std::shared_ptr<const Bytes> find(const ContentHash& hash) const override { return contents_.at(hash); }

  std::optional<LearnedPlace> fix(std::uint32_t index, double beyond_m = 0.0) {
    Step step;
    step.previous_from_current = Metric2{{0.25, 0.0, 0.0}};
    learned_places_.advance(step);
    const Relation here = Metric2{{beyond_m, 0.0, 0.0}};
    auto seen = std::make_shared<MarksMethod::Content>();
    seen->sightings.resize(1);
    return learned_places_.pass(Fix{{kRun, index}, here, {}}, seen, {window_, *this}, decoded_);
  }
  /// Drives by all places from the first to the one before the last. Returns what was learned.
  std::vector<LearnedPlace> drive(std::uint32_t first, std::uint32_t last) {
    std::vector<LearnedPlace> all;
    for (std::uint32_t i = first; i <= last; ++i) {
      for (const double beyond_m : {-0.2, 0.05})
        if (auto learned_place = fix(i, beyond_m)) all.push_back(std::move(*learned_place));
    }
    return all;
  }
  std::size_t passes_in(const LearnedPlace& learned_place) const {
    return method_.decode(learned_place.content)->sightings.size() - 1;
  }

  static constexpr std::uint32_t kMemory = 16;
  LearningMarks method_{2};
  PlaceLearner<LearningMarks> learned_places_{method_, {.enabled = true, .places = kMemory, .sure_m = 0.6}};
  DecodedContents<LearningMarks> decoded_{method_, 1U << 20U};
  Window window_;
  std::map<ContentHash, std::shared_ptr<const Bytes>> contents_;
};

TEST_F(LearnedPlacesOf, IsGivenOutOnceItIsWorthIt) {
  EXPECT_TRUE(drive(0, 10).empty()) << "one pass is not worth it yet";
  learned_places_.leave();
  const std::vector<LearnedPlace> all = drive(0, 10);
  ASSERT_EQ(all.size(), 10U) << "not of the place where it still is";
  EXPECT_EQ(all.front().place, (PlaceId{kRun, 0}));
  EXPECT_EQ(all.front().made_of, window_.place({kRun, 0})->content.hash);
  EXPECT_EQ(all.front().content_format, 2U);
  EXPECT_EQ(passes_in(all.front()), 2U);
  learned_places_.leave();
  EXPECT_TRUE(drive(0, 10).empty()) << "not again";
}

TEST_F(LearnedPlacesOf, TheViewNearestToThePlaceIsLearnedFrom) {
  for (int i = 0; i < 2; ++i) {
    learned_places_.leave();
    fix(1);
    for (const double beyond_m : {-0.3, -0.2, 0.2, 0.3}) fix(2, beyond_m);
    for (const double beyond_m : {-0.3, 0.01, 0.2, 0.3}) fix(3, beyond_m);
    if (i == 0) fix(5);
  }
  EXPECT_TRUE(fix(5)) << "of place 3, by the second of four views";
}

TEST_F(LearnedPlacesOf, WhatWasLearnedUponAnotherContentIsVoid) {
  drive(0, 4);
  put(2, 77);
  learned_places_.leave();
  std::set<PlaceId> taught;
  for (const LearnedPlace& learned_place : drive(0, 4)) taught.insert(learned_place.place);
  EXPECT_EQ(taught, (std::set<PlaceId>{{kRun, 0}, {kRun, 1}, {kRun, 3}}));
  learned_places_.leave();
  const std::vector<LearnedPlace> third = drive(0, 4);
  ASSERT_EQ(third.size(), 1U);
  EXPECT_EQ(third.front().made_of, window_.place({kRun, 2})->content.hash);
  EXPECT_EQ(passes_in(third.front()), 2U) << "upon the new one";
}

TEST_F(LearnedPlacesOf, ThePlacesPassedLongestAgoAreForgotten) {
  drive(0, 4);
  drive(5, 5 + kMemory);
  learned_places_.leave();
  EXPECT_TRUE(drive(0, 4).empty());
}

TEST_F(LearnedPlacesOf, APlaceThatIsGoneTeachesNothing) {
  drive(0, 4);
  window_.places.erase_all({PlaceId{kRun, 2}});
  learned_places_.leave();
  for (const LearnedPlace& learned_place : drive(0, 4)) EXPECT_NE(learned_place.place, (PlaceId{kRun, 2}));
}

TEST_F(LearnedPlacesOf, SwayingBetweenTwoPlacesIsNoPass) {
  fix(1);
  for (int i = 0; i < 2; ++i) {
    EXPECT_FALSE(fix(2));
    EXPECT_FALSE(fix(3));
  }
  drive(5, 8);
  learned_places_.leave();
  const std::vector<LearnedPlace> next = drive(1, 4);
  ASSERT_EQ(next.size(), 2U) << "of both, now that they are passed again";
  for (const LearnedPlace& learned_place : next) EXPECT_EQ(passes_in(learned_place), 2U);
}

TEST_F(LearnedPlacesOf, TheViewThatEndsAWayBlindIsNotLearnedFrom) {
  fix(1);
  std::vector<PlaceId> taught;
  for (int i = 0; i < 2; ++i) {
    Step step;
    step.previous_from_current = Metric2{{2.0, 0.0, 0.0}};
    learned_places_.advance(step);
    for (const std::uint32_t place : {2U, 3U, 4U})
      if (const auto learned_place = fix(place)) taught.push_back(learned_place->place);
    learned_places_.leave();
  }
  EXPECT_EQ(taught, (std::vector<PlaceId>{{kRun, 3}}));
}

class LearnsOnItsWay : public MarksFleet {
 protected:
  NavigatedRobot robot(const NavigationConfig& config) {
    test::MarksRobotConfig marks;
    marks.base = {0.1, 1, 0.02, 0.02, 0.01};
    return NavigatedRobot(world, marks, truth.at({first, 0}), 3, make_navigator(LearningMarks{}, config));
  }
  /// Returns what it has learned when it has driven all of the way.
  std::vector<LearnedPlace> driven(const NavigationConfig& config) {
    NavigatedRobot one = robot(config);
    one.navigator().seek(PlaceId{first, 0});
    run(one, 10);
    std::vector<LearnedPlace> all;
    const Driven way = drive(one, route_to_last({first, 0}), 1.0, [&](const Navigated& now) {
      all.insert(all.end(), now.learned_places.begin(), now.learned_places.end());
    });
    EXPECT_EQ(way.last.following, Following::arrived) << way.last.reason;
    return all;
  }
};

TEST_F(LearnsOnItsWay, OfMostPlacesOnceWhileItDrivesByItself) {
  teach(first, Course({5, 5, 0}).straight(4.0).poses);
  const std::vector<LearnedPlace> all = driven({});
  std::set<PlaceId> places;
  for (const LearnedPlace& learned_place : all) {
    EXPECT_TRUE(places.insert(learned_place.place).second) << "once a pass";
    const Place* const place = server.window().place(learned_place.place);
    ASSERT_NE(place, nullptr);
    EXPECT_EQ(learned_place.made_of, place->content.hash);
    EXPECT_EQ(learned_place.content_format, 2U);
  }
  EXPECT_GT(places.size(), server.window().places.size() / 2);
}

TEST_F(LearnsOnItsWay, NothingWhereItIsNotTo) {
  teach(first, Course({5, 5, 0}).straight(4.0).poses);
  NavigationConfig off;
  off.learn.enabled = false;
  EXPECT_TRUE(driven(off).empty());
}

TEST_F(LearnsOnItsWay, NothingWhileAHandDrives) {
  teach(first, Course({5, 5, 0}).straight(4.0).poses);
  NavigatedRobot one = robot({});
  one.navigator().seek(PlaceId{first, 0});
  run(one, 10);
  one.navigator().follow(route_to_last({first, 0}));
  int fixes = 0;
  one.hand(Course({5, 5, 0}).straight(4.0).poses, [&] {
    const Navigated now = one.step(server.map(), true);
    fixes += now.fix ? 1 : 0;
    EXPECT_TRUE(now.learned_places.empty());
  });
  EXPECT_GT(fixes, 10);
}

}  // namespace
}  // namespace weft::agents
