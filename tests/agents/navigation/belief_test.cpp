#include "agents/navigation/belief.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/network/change.hpp"
#include "core/random.hpp"

namespace weft::agents {
namespace {

constexpr PlaceId kHere{{1}, 0};
constexpr PlaceId kThere{{1}, 1};

Metric2 metric(const Pose2& pose, double sigma_m, double sigma_rad) {
  Metric2 result{pose, Eigen::Matrix3d::Zero()};
  result.covariance.diagonal() << sigma_m * sigma_m, sigma_m * sigma_m, sigma_rad * sigma_rad;
  return result;
}

Fix fix_at(const PlaceId& place, const Pose2& pose, double sigma_m = 0.01) {
  return {place, metric(pose, sigma_m, 0.01), {}};
}

Step seen_step(double metres) {
  return {metric({metres, 0, 0}, 0.002, 0.002), true, {}};
}

/// Returns a window of two places 0.2 m apart.
Window two_places() {
  Window window;
  for (const PlaceId& id : {kHere, kThere}) {
    Place place;
    place.id = id;
    window.places.emplace(id, place);
  }
  Edge edge;
  edge.id = {kHere, kThere};
  edge.a_from_b = metric({0.2, 0, 0}, 0.002, 0.002);
  window.edges.emplace(edge.id, edge);
  index_edges(window);
  return window;
}

/// Shows that a calibration's error, the same all the way, adds up: 1 % of 10 m, not 1 % of each step and their root.
TEST(Belief, AnErrorThatAllStepsHaveInCommonGrowsWithTheWayUntilAFix) {
  const auto driven = [](Belief& belief, int steps) {
    for (int i = 0; i < steps; ++i) {
      Step step = seen_step(0.1);
      step.common(0, 0) = 0.001;
      std::get<Metric2>(step.previous_from_current).covariance(0, 0) += 0.001 * 0.001;
      belief.advance(step);
    }
    return std::sqrt(planar_covariance(belief.estimate()->place_from_robot)(0, 0));
  };
  Belief belief{BeliefConfig{}};
  belief.set(fix_at(kHere, {0, 0, 0}, 0.0));
  EXPECT_NEAR(driven(belief, 100), std::hypot(0.1, 0.02), 1e-4);
  belief.set(fix_at(kHere, {0, 0, 0}, 0.0));
  EXPECT_NEAR(driven(belief, 1), std::hypot(0.001, 0.002), 1e-4) << "a fix takes the error back";
}

TEST(Fuse, LiesBetweenPredictionAndMeasurementByTheirCertainty) {
  const Relation fused = fuse(metric({0.0, 0, 0}, 0.01, 0.01), metric({0.09, 0, 0}, 0.02, 0.01));
  EXPECT_NEAR(planar(fused).x, 0.09 * 1.0 / 5.0, 1e-6);
  EXPECT_LT(planar_covariance(fused)(0, 0), 0.01 * 0.01);
  EXPECT_TRUE(check(fused));
}

TEST(Fuse, EachKindOfRelationIsFusedInItsOwnWay) {
  const auto along = std::get<AlongPath>(fuse(AlongPath{1.0, 0.01, 0.1, 0.04}, AlongPath{1.2, 0.01, 0.2, 0.01}));
  EXPECT_NEAR(along.distance_m, 1.1, 1e-6);
  EXPECT_NEAR(along.heading_shift_rad, 0.18, 1e-6);
  EXPECT_NEAR(along.distance_variance_m2, 0.005, 1e-6);
  Metric3 a{lift({0, 0, 0}), 1e-4 * Matrix6d::Identity()};
  Metric3 b{lift({0.1, 0, 0.1}), 1e-4 * Matrix6d::Identity()};
  const Relation middle = fuse(a, b);
  EXPECT_NEAR(planar(middle).x, 0.05, 1e-3);
  EXPECT_NEAR(planar(middle).heading, 0.05, 1e-3);
  // What is measured counts alone when the kinds differ.
  EXPECT_EQ(fuse(a, AlongPath{1.0, 0.01, 0, 0.01}).index(), Relation(AlongPath{}).index());
}

TEST(Disagreement, IsMeasuredInSigmasAndNeverWithoutAFloor) {
  const BeliefConfig config;
  const double close = disagreement(config, metric({0, 0, 0}, 0, 0), metric({config.gate_floor_m, 0, 0}, 0, 0));
  EXPECT_NEAR(close, 1.0, 1e-9);
  EXPECT_LT(disagreement(config, metric({0, 0, 0}, 0.3, 0.1), metric({0.3, 0, 0}, 0, 0)), 1.1);
  EXPECT_GT(disagreement(config, metric({0, 0, 0}, 0.01, 0.01), metric({0.3, 0, 0}, 0.01, 0.01)), 5.0);
}

TEST(Disagreement, OfTwoPosesInSpaceIsInSpace) {
  BeliefConfig config;
  const auto at = [](const Vector6d& xi) { return Metric3{se3_exp(xi), 1e-6 * Matrix6d::Identity()}; };
  const Metric3 here = at(Vector6d::Zero());
  for (const Eigen::Index axis : {2, 3, 4}) {  // z, roll, pitch
    Vector6d off = Vector6d::Zero();
    off[axis] = 0.5;
    config.in_plane = false;
    EXPECT_GT(disagreement(config, here, at(off)), config.gate_sigmas) << axis;
    config.in_plane = true;
    EXPECT_LT(disagreement(config, here, at(off)), config.gate_sigmas)
        << axis << ": a robot of the plane asked for it";
  }
}

TEST(Belief, AFixInSpaceThatIsWrongInHeightAloneIsRefused) {
  Belief belief{BeliefConfig{}};
  const Metric3 here{Pose3{}, 1e-6 * Matrix6d::Identity()};
  belief.set(Fix{kHere, here, {}});
  Metric3 above = here;
  above.a_from_b.translation.z() = 0.4;
  const auto refused = belief.correct(Fix{kHere, above, {}}, here, Window{});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().reason, "disagrees_with_prediction");
}

TEST(Belief, MovesWithOdometryAndCountsWhatItDroveBlind) {
  Belief belief{BeliefConfig{}};
  belief.set(fix_at(kHere, {0, 0, 0}));
  for (int i = 0; i < 10; ++i) belief.advance(seen_step(0.05));
  ASSERT_TRUE(belief.estimate());
  EXPECT_NEAR(planar(belief.estimate()->place_from_robot).x, 0.5, 1e-9);
  EXPECT_NEAR(belief.estimate()->blind_m, 0.5, 1e-9);
  EXPECT_GT(planar_covariance(belief.estimate()->place_from_robot)(0, 0), 1e-4);
}

TEST(Belief, OneNoisyFixDoesNotJerkIt) {
  const Window window = two_places();
  for (const bool fused : {true, false}) {
    BeliefConfig config;
    config.fuse = fused;
    Belief belief{config};
    belief.set(fix_at(kHere, {0, 0, 0}, 0.005));
    belief.advance(seen_step(0.05));
    const Fix noisy = fix_at(kHere, {0.05, 0.06, 0}, 0.03);
    const auto believed = belief.correct(noisy, belief.estimate()->place_from_robot, window);
    ASSERT_TRUE(believed);
    const double moved_aside = planar(belief.estimate()->place_from_robot).y;
    EXPECT_EQ(belief.estimate()->blind_m, 0.0);
    if (fused) {
      EXPECT_LT(moved_aside, 0.01);
    } else {
      EXPECT_NEAR(moved_aside, 0.06, 1e-9);
    }
  }
}

TEST(Belief, FusionBeatsSingleFixes) {
  const Window window = two_places();
  const auto error_of = [&](bool fused) {
    BeliefConfig config;
    config.fuse = fused;
    Belief belief{config};
    Random random(5);
    belief.set(fix_at(kHere, {0, 0, 0}));
    double squared = 0.0;
    for (int i = 1; i <= 200; ++i) {
      belief.advance(
          {metric({0.01 + random.normal(0, 0.0005), 0, random.normal(0, 0.0005)}, 0.0005, 0.0005), true, {}});
      const Pose2 truly{0.01 * i, 0, 0};
      const Pose2 noise{random.normal(0, 0.01), random.normal(0, 0.01), random.normal(0, 0.01)};
      const auto corrected =
          belief.correct(fix_at(kHere, truly * noise), belief.estimate()->place_from_robot, window);
      EXPECT_TRUE(corrected);
      squared += (planar(belief.estimate()->place_from_robot).translation() - truly.translation()).squaredNorm();
    }
    return std::sqrt(squared / 200);
  };
  EXPECT_LT(error_of(true), 0.6 * error_of(false));
}

TEST(Belief, AFixThatContradictsIsRefusedWithItsMeasure) {
  const Window window = two_places();
  Belief belief{BeliefConfig{}};
  belief.set(fix_at(kHere, {0, 0, 0}));
  const auto refused = belief.correct(fix_at(kHere, {0.5, 0.5, 0}), belief.estimate()->place_from_robot, window);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().reason, "disagrees_with_prediction");
  EXPECT_GT(refused.error().measured, refused.error().bound);
  EXPECT_NEAR(planar(belief.estimate()->place_from_robot).x, 0.0, 1e-9);
}

TEST(Belief, FixesThatAgreeWithOneAnotherOverruleIt) {
  const BeliefConfig config;
  const Window window = two_places();
  Belief belief{config};
  belief.set(fix_at(kHere, {0, 0, 0}));
  for (std::uint32_t i = 1; i < config.overrule_fixes; ++i) {
    EXPECT_FALSE(belief.correct(fix_at(kHere, {0.5, 0.5, 0}), belief.estimate()->place_from_robot, window));
  }
  EXPECT_TRUE(belief.correct(fix_at(kHere, {0.5, 0.5, 0}), belief.estimate()->place_from_robot, window));
  EXPECT_NEAR(planar(belief.estimate()->place_from_robot).x, 0.5, 1e-9);
}

TEST(Belief, UnseededItIsMadeByFixesOfTwoPlacesThatAgree) {
  const Window window = two_places();
  Belief belief{BeliefConfig{}};
  const auto first = belief.propose(fix_at(kHere, {0.1, 0, 0}), window, 2);
  ASSERT_FALSE(first);
  EXPECT_EQ(first.error().reason, "unconfirmed");
  EXPECT_FALSE(belief.estimate());
  belief.advance(seen_step(0.05));
  EXPECT_TRUE(belief.propose(fix_at(kThere, {-0.05, 0, 0}), window, 2));
  ASSERT_TRUE(belief.estimate());
  EXPECT_EQ(belief.estimate()->place, kThere);
}

TEST(Belief, UnseededFixesThatDisagreeMakeNone) {
  const Window window = two_places();
  Belief belief{BeliefConfig{}};
  for (const double y : {0.0, 0.5, -0.5, 0.9, -0.9}) {
    EXPECT_FALSE(belief.propose(fix_at(kHere, {0.1, y, 0}), window, 2));
  }
  // Places that nothing joins cannot confirm each other.
  EXPECT_FALSE(belief.propose(fix_at({{9}, 4}, {0, 0, 0}), window, 2));
  EXPECT_FALSE(belief.estimate());
}

TEST(Between, ComposesAlongTheWindowBothWays) {
  const Window window = two_places();
  const BeliefConfig config;
  EXPECT_NEAR(planar(between(config, window, kHere, kThere, 3).value()).x, 0.2, 1e-9);
  EXPECT_NEAR(planar(between(config, window, kThere, kHere, 3).value()).x, -0.2, 1e-9);
  EXPECT_FALSE(between(config, window, kHere, {{9}, 9}, 3));
}

TEST(NavigationConfig, BadBoundsAreAllNamed) {
  NavigationConfig config;
  EXPECT_TRUE(check(config).empty());
  config.teach.spacing_m = 0;
  config.follow.speed_m_s = 9;
  config.locate.seek_tries = 0;
  const std::vector<Error> issues = check(config);
  ASSERT_EQ(issues.size(), 3U);
  EXPECT_NE(issues[0].message.find("teach.spacing_m"), std::string::npos);
  EXPECT_NE(issues[1].message.find("locate.seek_tries"), std::string::npos);
  EXPECT_NE(issues[2].message.find("follow.speed_m_s"), std::string::npos);
  EXPECT_NE(issues[2].message.find("2.0"), std::string::npos);
}

TEST(NavigationConfig, ARobotSlowsDownBeforeItIsLost) {
  NavigationConfig config;
  config.follow.blind_limit_m = config.follow.sure_m;
  const std::vector<Error> issues = check(config);
  ASSERT_EQ(issues.size(), 1U);
  EXPECT_NE(issues[0].message.find("follow.sure_m is 0.4"), std::string::npos);
  EXPECT_NE(issues[0].message.find("below follow.blind_limit_m"), std::string::npos);
}

TEST(BeliefOfAPosterior, AFixThatAgreesIsTakenAsItIs) {
  Belief belief(BeliefConfig{}, true);
  belief.set(fix_at(kHere, {0, 0, 0}));
  const Fix fix = fix_at(kHere, {0.03, 0.01, 0.0}, 0.02);
  const auto believed = belief.correct(fix, belief.estimate()->place_from_robot, two_places());
  ASSERT_TRUE(believed);
  EXPECT_TRUE(identical(believed->place_from_robot, fix.place_from_robot)) << "odometry is in it already";
  EXPECT_TRUE(identical(belief.estimate()->place_from_robot, fix.place_from_robot));
  Belief weighs{BeliefConfig{}};
  weighs.set(fix_at(kHere, {0, 0, 0}));
  const auto fused = weighs.correct(fix, weighs.estimate()->place_from_robot, two_places());
  ASSERT_TRUE(fused);
  EXPECT_LT(planar(fused->place_from_robot).x, 0.02);
}

TEST(BeliefOfAPosterior, IsGatedAndOverruledLikeAnyOther) {
  Belief belief(BeliefConfig{}, true);
  belief.set(fix_at(kHere, {0, 0, 0}));
  const Fix wrong = fix_at(kHere, {0.8, 0, 0});
  const BeliefConfig config;
  for (std::uint32_t times = 1; times < config.overrule_fixes; ++times) {
    const auto refused = belief.correct(wrong, belief.estimate()->place_from_robot, two_places());
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.error().reason, "disagrees_with_prediction");
  }
  ASSERT_TRUE(belief.correct(wrong, belief.estimate()->place_from_robot, two_places()));
  EXPECT_TRUE(identical(belief.estimate()->place_from_robot, wrong.place_from_robot));
}

}  // namespace
}  // namespace weft::agents
