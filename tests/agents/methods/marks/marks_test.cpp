#include "tests/support/marks.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/marks_world.hpp"

namespace weft::agents {
namespace {

using test::MarksRobot;
using test::MarksRobotConfig;
using test::MarksWorld;
using test::MarksWorldConfig;

MarksMethod::Content content_at(const MarksMethod& method, const MarksWorld& world, const Pose2& pose,
                                Random& random) {
  View view;
  view.data = world.see(pose, random);
  return method.extract({}, view).value();
}

double off(const Pose2& a, const Pose2& b) {
  return (a.translation() - b.translation()).norm();
}

TEST(MarksMethod, RelatesTwoViewsOfOnePatch) {
  const MarksWorld world({}, 1);
  const MarksMethod method;
  Random random(2);
  const Pose2 world_from_a{10, 10, 0.3};
  for (const Pose2& a_from_b : {Pose2{0, 0, 0}, Pose2{0.3, -0.1, 0.4}, Pose2{-0.2, 0.4, -1.2}, Pose2{0.8, 0, 3.0}}) {
    const auto a = content_at(method, world, world_from_a, random);
    const auto b = content_at(method, world, world_from_a * a_from_b, random);
    const auto related = method.relate(a, b, std::nullopt);
    ASSERT_TRUE(related) << related.error().reason;
    EXPECT_LT(off(planar(related->a_from_b), a_from_b), 0.02);
    EXPECT_NEAR(wrap_angle(planar(related->a_from_b).heading - a_from_b.heading), 0.0, 0.02);
  }
}

TEST(MarksMethod, CovarianceIsAboutRight) {
  const MarksWorld world({}, 3);
  const MarksMethod method;
  Random random(4);
  const Pose2 world_from_a{10, 10, 0.3};
  const Pose2 a_from_b{0.2, 0.1, 0.2};
  double squared = 0.0;
  constexpr int runs = 200;
  for (int i = 0; i < runs; ++i) {
    const auto related = method.relate(content_at(method, world, world_from_a, random),
                                       content_at(method, world, world_from_a * a_from_b, random), std::nullopt);
    ASSERT_TRUE(related);
    const auto& measured = std::get<Metric2>(related->a_from_b);
    const Eigen::Vector3d error = se2_log(a_from_b.inverse() * measured.a_from_b);
    squared += error.dot(measured.covariance.inverse() * error);
  }
  EXPECT_GT(squared / runs, 0.7);  // 3 when exact; the configured sigmas are a quarter above the world's
  EXPECT_LT(squared / runs, 4.5);
}

TEST(MarksMethod, WrongNumbersAreOutvoted) {
  MarksWorldConfig config;
  config.wrong_share = 0.2;
  const MarksWorld world(config, 5);
  const MarksMethod method;
  Random random(6);
  int related_count = 0;
  for (int i = 0; i < 200; ++i) {
    const Pose2 world_from_a{random.uniform(5, 35), random.uniform(5, 35), random.uniform(-3, 3)};
    const Pose2 a_from_b{random.uniform(-0.3, 0.3), random.uniform(-0.2, 0.2), random.uniform(-0.3, 0.3)};
    const auto related = method.relate(content_at(method, world, world_from_a, random),
                                       content_at(method, world, world_from_a * a_from_b, random), std::nullopt);
    if (!related) continue;
    ++related_count;
    EXPECT_LT(off(planar(related->a_from_b), a_from_b), 0.05);
  }
  EXPECT_GT(related_count, 180);
}

TEST(MarksMethod, ViewsThatShareNumbersButNoPatchAreRefused) {
  const MarksMethod method;
  MarksMethod::Content a;
  MarksMethod::Content b;
  for (std::uint64_t mark = 1; mark <= 4; ++mark) {
    const double i = static_cast<double>(mark);
    a.sightings.push_back({mark, {0.3 * i, 0.1 * i * i, 0.2}});
    b.sightings.push_back({mark, {0.2 * i * i - 1.0, 0.4 * i, 0.7 * i}});
  }
  const auto related = method.relate(a, b, std::nullopt);
  ASSERT_FALSE(related);
  EXPECT_EQ(related.error().reason, "inconsistent_marks");
  EXPECT_LT(related.error().measured, related.error().bound);
}

TEST(MarksMethod, OneCommonMarkNeedsAGuess) {
  const MarksMethod method;
  const MarksMethod::Content a{{{7, {1, 0, 0}}}};
  const MarksMethod::Content b{{{7, {0.5, 0, 0}}, {8, {0, 1, 0}}}};
  EXPECT_EQ(method.relate(a, b, std::nullopt).error().reason, "few_marks");
  const auto related = method.relate(a, b, Relation{Metric2{}});
  ASSERT_TRUE(related);
  EXPECT_NEAR(planar(related->a_from_b).x, 0.5, 1e-9);
  EXPECT_EQ(related->inliers, 1U);
}

TEST(MarksMethod, ObserveFollowsTheRobotAndSaysWhenItWasBlind) {
  MarksWorldConfig config;
  config.blank = {{7.0, 5.0, 0.5}};
  const MarksWorld world(config, 7);
  const MarksMethod method;
  MarksRobot robot(world, MarksRobotConfig{}, {5, 5, 0}, 8);
  MarksMethod::Odometry odometry;
  const auto first = robot.step({});
  EXPECT_FALSE(method.observe(odometry, first.of("marks"), first.motion).seen);
  Pose2 world_from_robot = robot.world_from_robot();
  int blind = 0;
  for (int i = 0; i < 100; ++i) {
    const auto sample = robot.step({0.4, 0.02});
    const Step step = method.observe(odometry, i == 50 ? nullptr : sample.of("marks"), sample.motion);
    EXPECT_TRUE(check(step.previous_from_current));
    EXPECT_EQ(step.blind_reason.empty(), step.seen);
    blind += step.seen ? 0 : 1;
    world_from_robot = world_from_robot * planar(step.previous_from_current);
  }
  EXPECT_GT(blind, 10);
  EXPECT_LT(blind, 60);
  EXPECT_LT(off(world_from_robot, robot.world_from_robot()), 0.12);
}

TEST(MarksMethod, AViewFromSomewhereElseDoesNotMoveTheRobot) {
  const MarksWorld world({}, 13);
  const MarksMethod method;
  Random random(14);
  MarksMethod::Odometry odometry;
  const Pose2 here{10, 10, 0.3};
  Motion still;
  still.elapsed = from_seconds(0.1);
  still.wheels = WheelStep{};
  const auto observe = [&](const Pose2& from, const Motion& motion) {
    View view;
    view.data = world.see(from, random);
    return method.observe(odometry, &view, motion);
  };
  ASSERT_FALSE(observe(here, still).seen);
  ASSERT_TRUE(observe(here, still).seen);
  // Close enough to share marks that agree with one another: only the wheels know better.
  const Step away = observe(here * Pose2{0.5, 0.0, 0.0}, still);
  EXPECT_EQ(away.blind_reason, "disagrees_with_wheels");
  EXPECT_LT(distance_m(away.previous_from_current), 1e-9);
  const Step back = observe(here, still);
  EXPECT_FALSE(back.seen);
  EXPECT_LT(distance_m(back.previous_from_current), 1e-9);
  EXPECT_TRUE(observe(here, still).seen);
}

TEST(MarksMethod, AnotherSensorsViewIsRefused) {
  View view;
  view.data = Image{};
  EXPECT_EQ(MarksMethod().extract({}, view).error().reason, "not_marks");
  view.data = Marks{};
  EXPECT_EQ(MarksMethod().extract({}, view).error().reason, "no_marks");
}

TEST(MarksMethod, ContentSurvivesItsBytes) {
  const MarksWorld world({}, 9);
  const MarksMethod method;
  Random random(10);
  const auto content = content_at(method, world, {10, 10, 1}, random);
  const Bytes bytes = method.encode(content);
  const auto again = method.decode(bytes);
  ASSERT_TRUE(again);
  EXPECT_EQ(method.encode(*again), bytes);
  ASSERT_EQ(again->sightings.size(), content.sightings.size());
  EXPECT_EQ(again->sightings.front().robot_from_mark, content.sightings.front().robot_from_mark);
}

TEST(MarksMethod, DamagedBytesAreCorrupt) {
  const MarksMethod method;
  const MarksMethod::Content content{{{1, {1, 0, 0}}, {2, {0, 1, 0}}}};
  const Bytes good = method.encode(content);
  for (std::size_t size = 0; size < good.size(); ++size) {
    EXPECT_FALSE(method.decode(ByteView(good).first(size))) << size;
  }
  Bytes not_finite = good;
  not_finite[22] = 0xf8;
  not_finite[23] = 0x7f;  // x of the first sighting
  EXPECT_FALSE(method.decode(not_finite));
  Bytes unordered = good;
  unordered[8] = 9;
  const auto result = method.decode(unordered);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().code, ErrorCode::corrupt);
  Bytes huge = good;
  huge[7] = 0xff;
  EXPECT_FALSE(method.decode(huge));
}

TEST(MarksMethod, SignaturesOfNearViewsAreNearer) {
  const MarksWorld world({}, 11);
  const MarksMethod method;
  Random random(12);
  const auto here = method.sign(content_at(method, world, {10, 10, 0}, random)).value();
  const auto near = method.sign(content_at(method, world, {10.1, 10, 0}, random)).value();
  const auto far = method.sign(content_at(method, world, {20, 25, 0}, random)).value();
  const auto distance = [](const Signature& a, const Signature& b) {
    float sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
    return sum;
  };
  EXPECT_LT(distance(here, near), 0.5F * distance(here, far));
  EXPECT_FALSE(method.sign({}).has_value());
}

TEST(MarksMethod, BadBoundsAreNamed) {
  MarksConfig config;
  EXPECT_TRUE(check(config).empty());
  config.agree_m = 0;
  ASSERT_EQ(check(config).size(), 1U);
  EXPECT_NE(check(config)[0].message.find("agree_m"), std::string::npos);
}

}  // namespace
}  // namespace weft::agents
