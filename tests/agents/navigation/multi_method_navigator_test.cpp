// What several navigators are as one, with navigators that do as they are told.
#include "agents/navigation/multi_method_navigator.hpp"

#include <gtest/gtest.h>

#include "agents/navigation/method_switch.hpp"

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr ExperienceId kFloorRun{1};
constexpr ExperienceId kAheadRun{2};

struct Told {
  std::optional<Estimate> estimate;
  Navigated answer;
  std::vector<Motion> motions;
  int blind = 0;
  std::vector<std::uint32_t> followed_from;
  std::vector<Estimate> hints;
  std::vector<TeachStart> taught;
  std::optional<Question> question;
  std::vector<std::uint64_t> proposed;
  int sought = 0;
  int stops = 0;
  bool is_taught = false;
};

class Part final : public Navigator {
 public:
  Part(std::string_view method, Told& told) : method_(method), told_(told) {}
  std::string_view method() const override { return method_; }
  Navigated step(const Sample& sample, const MapView&) override {
    told_.motions.push_back(sample.motion);
    if (sample.views.empty()) ++told_.blind;
    return told_.answer;
  }
  void begin_teach(const TeachStart& start) override { told_.taught.push_back(start); }
  std::vector<Kept> end_teach(const MapView&) override { return {}; }
  bool is_taught() const override { return told_.is_taught; }
  std::vector<Edge> leave_teach() override {
    told_.is_taught = false;
    return {};
  }
  void keep_place() override {}
  OrRefusal<Kept> keep_alone(const TeachStart&, const MapView&) override { return tl::unexpected(Refusal{"no"}); }
  bool map_changed(const Window&, const Window&) override { return true; }
  void forget_taught(const Window&) override {}
  void forget_where() override { told_.estimate.reset(); }
  void believe(const Estimate& estimate) override { told_.hints.push_back(estimate); }
  void seek(const std::optional<PlaceId>&) override { ++told_.sought; }
  void look_again() override {}
  void stop_looking() override {}
  const Question* question() const override { return told_.question ? &*told_.question : nullptr; }
  void propose(std::uint64_t number, const std::vector<PlaceId>&) override { told_.proposed.push_back(number); }
  std::optional<Estimate> estimate() const override { return told_.estimate; }
  Result<TeachReport> teach_report() const override { return fail(ErrorCode::refused, "none"); }
  void follow(const Route&, std::uint32_t from) override { told_.followed_from.push_back(from); }
  void stop() override { ++told_.stops; }

 private:
  std::string_view method_;
  Told& told_;
};

class NoContents final : public Contents {
 public:
  std::shared_ptr<const Bytes> find(const ContentHash&) const override { return nullptr; }
};

class MultiMethodNavigator : public testing::Test {
 protected:
  MultiMethodNavigator() {
    std::vector<SensorNavigator> all;
    all.push_back({"down", std::make_unique<Part>("floor", floor)});
    all.push_back({"ahead", std::make_unique<Part>("along", ahead)});
    robot = make_multi_method_navigator(std::move(all), {});
    for (std::uint32_t i = 0; i < 4; ++i) {
      add({kFloorRun, i}, "floor");
      add({kAheadRun, i}, "along");
      Edge change;
      change.id = {{kFloorRun, i}, {kAheadRun, i}};
      change.a_from_b = Metric2{};
      window.edges.emplace(change.id, change);
    }
    index_edges(window);
    route.places = {{kFloorRun, 0}, {kFloorRun, 1}, {kAheadRun, 1}, {kAheadRun, 2}};
    route.relations.assign(3, Metric2{Pose2{0.2, 0.0, 0.0}});
    route.released = 3;
  }
  void add(const PlaceId& id, const std::string& method) {
    Place place;
    place.id = id;
    place.method = method;
    window.places.emplace(id, place);
  }
  Navigated see(const std::string& sensor, Duration elapsed = 50ms, const Twist& command = {0.5, 0.0}) {
    Sample sample;
    sample.frame = ++frame;
    sample.motion = {elapsed, command, std::nullopt};
    if (!sensor.empty()) sample.views.push_back({frame, {}, sensor, {}, {}});
    return robot->step(sample, {window, contents});
  }

  Told floor, ahead;
  std::unique_ptr<Navigator> robot;
  Window window;
  NoContents contents;
  Route route;
  std::uint64_t frame = 0;
};

TEST_F(MultiMethodNavigator, EachGetsItsViewsAndAllMotionSinceItsLastOne) {
  see("down");
  see("ahead");
  see("down");
  ASSERT_EQ(floor.motions.size(), 2U);
  EXPECT_EQ(floor.motions.back().elapsed, 100ms) << "the other camera's time is its own, too";
  ASSERT_EQ(ahead.motions.size(), 1U);
  EXPECT_EQ(ahead.motions.back().elapsed, 100ms);
}

TEST_F(MultiMethodNavigator, ItIsTaughtUntilEachHasItsLastPlace) {
  floor.is_taught = ahead.is_taught = true;
  robot->begin_teach({kFloorRun, {}, {kAheadRun}});
  floor.is_taught = false;
  robot->end_teach({window, contents});
  EXPECT_TRUE(robot->is_taught()) << "the one that looks ahead had no view";
  ahead.is_taught = false;
  robot->end_teach({window, contents});
  EXPECT_FALSE(robot->is_taught());
}

TEST_F(MultiMethodNavigator, AWishForAnExposureIsOfTheCameraThatSees) {
  floor.answer.exposes = ExposureWish{"floor", {0.002, 1.0}};
  ahead.answer.exposes = ExposureWish{"forward", {0.01, 2.0}};
  ASSERT_TRUE(see("down").exposes);
  EXPECT_EQ(see("down").exposes->sensor, "floor");
  ASSERT_TRUE(see("ahead").exposes) << "who does not drive wishes, too";
  EXPECT_EQ(see("ahead").exposes->sensor, "forward");
  EXPECT_EQ(see("ahead").exposes->exposure.gain, 2.0);
  ahead.answer.exposes.reset();
  EXPECT_FALSE(see("ahead").exposes);
}

TEST_F(MultiMethodNavigator, ACameraThatIsSilentWhileTheRobotMovesIsBlind) {
  for (int i = 0; i < 5; ++i) see("down");
  EXPECT_EQ(ahead.blind, 0) << "250 ms are not late";
  for (int i = 0; i < 3; ++i) see("down");
  EXPECT_EQ(ahead.blind, 3) << "blind it is driven as if it were alone: at each sample";
  Duration told{};
  for (const Motion& motion : ahead.motions) told += motion.elapsed;
  EXPECT_EQ(told, 400ms) << "no motion is lost";
  EXPECT_EQ(floor.blind, 0);
  for (int i = 0; i < 8; ++i) see("");
  EXPECT_GE(floor.blind, 1) << "frames that were dropped, one after the other";
}

TEST_F(MultiMethodNavigator, ACameraThatWasQuietAtRestIsNotLateWhenTheRobotStarts) {
  for (int i = 0; i < 30; ++i) see("down", 50ms, {});
  for (int i = 0; i < 4; ++i) see("down");
  EXPECT_EQ(ahead.blind, 0);
  see("ahead");
  EXPECT_EQ(ahead.motions.back().elapsed, 35 * 50ms);
}

TEST_F(MultiMethodNavigator, WhoIsToldIsToldOfTheMotionOfBoth) {
  floor.estimate = Estimate{{kFloorRun, 1}, Metric2{}, 0.0};
  for (int i = 0; i < 20; ++i) see(i % 2 == 0 ? "down" : "ahead");
  ASSERT_EQ(ahead.hints.size(), 1U);
  EXPECT_NEAR(planar(ahead.hints.front().place_from_robot).x, 0.025, 1e-9) << "since the floor's last view";
  for (int i = 0; i < 20; ++i) see(i % 2 == 0 ? "ahead" : "down");
  ASSERT_EQ(ahead.hints.size(), 2U);
  EXPECT_NEAR(planar(ahead.hints.back().place_from_robot).x, -0.025, 1e-9) << "of this it will be told";
}

TEST_F(MultiMethodNavigator, SaysWhatItCanDrive) {
  EXPECT_EQ(robot->teaches(), (std::vector<std::string>{"floor", "along"}));
  EXPECT_EQ(robot->drives(), (std::vector<std::string>{"floor", "along", "along+floor"}));
}

TEST_F(MultiMethodNavigator, AreTaughtAnExperienceEach) {
  robot->begin_teach({kFloorRun, {}, {kAheadRun}});
  ASSERT_EQ(floor.taught.size(), 1U);
  ASSERT_EQ(ahead.taught.size(), 1U);
  EXPECT_EQ(floor.taught.front().experience, kFloorRun);
  EXPECT_EQ(ahead.taught.front().experience, kAheadRun);
}

TEST_F(MultiMethodNavigator, WhoKnowsTellsWhoDoesNot) {
  floor.estimate = Estimate{{kFloorRun, 1}, Metric2{}, 0.0};
  for (int i = 0; i < 30; ++i) see(i % 2 == 0 ? "down" : "ahead");
  ASSERT_EQ(ahead.hints.size(), 1U) << "once a second";
  EXPECT_EQ(ahead.hints.front().place, (PlaceId{kAheadRun, 1}));
  EXPECT_GT(ahead.hints.front().blind_m, 0.5) << "told is not seen";
}

TEST_F(MultiMethodNavigator, TheNextOneTakesOverAtTheChange) {
  floor.estimate = Estimate{{kFloorRun, 0}, Metric2{}, 0.0};
  ahead.estimate = Estimate{{kAheadRun, 0}, AlongPath{}, 0.1};
  floor.answer.command = {0.5, 0.0};
  ahead.answer.command = {0.4, 0.1};
  see("down");
  robot->follow(route, 0);
  EXPECT_EQ(floor.followed_from, (std::vector<std::uint32_t>{0}));
  EXPECT_EQ(see("ahead").command, floor.answer.command) << "the other drives";
  EXPECT_EQ(robot->method(), "floor");

  floor.estimate = Estimate{{kFloorRun, 1}, Metric2{}, 0.0};
  ahead.estimate = Estimate{{kAheadRun, 1}, AlongPath{}, 0.1};
  floor.answer.route_at = 1;
  EXPECT_EQ(see("down").command, floor.answer.command) << "until it has a command of its own the robot rolls on";
  EXPECT_EQ(robot->method(), "along");
  EXPECT_EQ(ahead.followed_from, (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(floor.stops, 1);
  ahead.answer.route_at = 1;
  const Navigated now = see("ahead");
  EXPECT_EQ(now.command, ahead.answer.command);
  EXPECT_EQ(robot->estimate()->place, (PlaceId{kAheadRun, 1}));
}

TEST_F(MultiMethodNavigator, WhatAnyOfThemHasLearnedIsPassedOnOnce) {
  ahead.answer.learned_places.push_back(
      {.place = {kAheadRun, 2}, .made_of = {}, .content_format = 2, .content = {7}});
  const Navigated now = see("ahead");
  ASSERT_EQ(now.learned_places.size(), 1U);
  EXPECT_EQ(now.learned_places.front().place, (PlaceId{kAheadRun, 2}));
  EXPECT_EQ(now.learned_places.front().content, Bytes{7});
  EXPECT_TRUE(see("down").learned_places.empty());
}

TEST_F(MultiMethodNavigator, NothingIsSaidOfTheRouteBefore) {
  floor.estimate = Estimate{{kFloorRun, 0}, Metric2{}, 0.0};
  floor.answer.following = Following::arrived;
  floor.answer.route_at = 3;
  floor.answer.command = {0.5, 0.0};
  robot->follow(route, 0);
  EXPECT_EQ(see("down").following, Following::arrived);
  Route other = route;
  other.id.bytes[0] = 7;
  robot->follow(other, 0);
  const Navigated now = see("ahead");
  EXPECT_EQ(now.following, Following::none) << "the one that drives has not been asked yet";
  EXPECT_EQ(now.route_at, 0U);
  see("down");
  robot->stop();
  EXPECT_EQ(see("ahead").command, Twist{}) << "stopped is stopped, whoever sees next";
}

TEST_F(MultiMethodNavigator, AnAnswerFindsBackToWhoAsked) {
  ahead.question = Question{.number = 1, .seen = {}, .method = "along"};
  const std::uint64_t of_ahead = robot->question()->number;
  floor.question = Question{.number = 1, .seen = {}, .method = "floor"};
  EXPECT_NE(robot->question()->number, of_ahead);
  robot->propose(of_ahead, {{kAheadRun, 2}});
  EXPECT_TRUE(floor.proposed.empty());
  EXPECT_EQ(ahead.proposed, (std::vector<std::uint64_t>{1}));
}

TEST_F(MultiMethodNavigator, WhoKnowsIsHeardAlsoWithARoute) {
  floor.estimate = Estimate{{kFloorRun, 0}, Metric2{}, 0.0};
  robot->follow(route, 0);
  floor.estimate.reset();
  ahead.estimate = Estimate{{kAheadRun, 0}, AlongPath{}, 0.0};
  see("down");
  ASSERT_TRUE(robot->estimate());
  EXPECT_EQ(robot->estimate()->place, (PlaceId{kAheadRun, 0}));
  robot->seek(std::nullopt);
  EXPECT_EQ(ahead.sought, 0) << "it knows";
  EXPECT_EQ(floor.sought, 1);
}

TEST_F(MultiMethodNavigator, WhoSeesOnlyAFarPlaceDoesNotSayWhereARouteBegins) {
  ahead.estimate = Estimate{{kAheadRun, 0}, Metric2{Pose2{-3.0, 0.0, 0.0}}, 0.0};
  see("ahead");
  ASSERT_TRUE(robot->estimate());
  EXPECT_EQ(robot->method(), "along") << "nobody else knows";
  floor.estimate = Estimate{{kFloorRun, 2}, Metric2{Pose2{0.1, 0.0, 0.0}}, 0.0};
  see("down");
  EXPECT_EQ(robot->estimate()->place, (PlaceId{kFloorRun, 2})) << "no route can be joined 3 m before its first place";
  ahead.estimate = Estimate{{kAheadRun, 1}, Metric2{}, 0.0};
  see("ahead");
  EXPECT_EQ(robot->method(), "floor") << "who may begin a route there stays";
}

TEST_F(MultiMethodNavigator, WhoHasNotSeenWhereItIsDoesNotTakeOver) {
  floor.estimate = Estimate{{kFloorRun, 1}, Metric2{}, 0.0};
  ahead.estimate = Estimate{{kAheadRun, 1}, AlongPath{}, 0.9};
  floor.answer.route_at = 1;
  see("down");
  robot->follow(route, 0);
  see("down");
  EXPECT_EQ(robot->method(), "floor") << "0.9 m without a fix";
  ahead.estimate = Estimate{{kAheadRun, 3}, AlongPath{0.4, 0.0, 0.0, 0.0}, 0.0};
  window.edges.erase_all({EdgeId{{kFloorRun, 3}, {kAheadRun, 3}}});
  index_edges(window);
  see("down");
  EXPECT_EQ(robot->method(), "floor") << "nothing says that both may be right";
}

}  // namespace
}  // namespace weft::agents
