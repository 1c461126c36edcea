#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/agents/methods/topometric/localised_drive.hpp"

namespace weft::agents {
namespace {

TaughtSite taught_straight(const MadeSite& site, const Pose2& from, double length_m) {
  Random random(21);
  TaughtSite taught;
  taught.teach_straight(site, from, length_m, random);
  return taught;
}

TopometricConfig scan_only() {
  TopometricConfig config;
  config.belief.uses_features = false;
  return config;
}

/// Holds what came of following a robot along a corridor.
struct Followed {
  double mean_m = 0.0, worst_m = 0.0, jump_m = 0.0;
  int switches = 0, fixes = 0, looks = 0, within = 0;
};
Followed follow(const TopometricConfig& config, std::uint64_t seed) {
  const MadeSite site = niched_corridor();
  const TaughtSite taught = taught_straight(site, {}, 18.0);
  LocalisedDrive drive(site, taught, config, seed);
  drive.begin({}, {}, 0.05, 0.03);
  Followed followed;
  constexpr double chi2_95 = 7.815;  // three degrees of freedom
  while (drive.truth().x < 17.0) {
    const double back = -drive.estimate().heading - 0.5 * drive.estimate().y;  // keeps to the middle
    const Located<TopometricBelief> located = drive.next({0.1, 0.0, std::clamp(back, -0.1, 0.1)});
    followed.mean_m += drive.off_m();
    followed.worst_m = std::max(followed.worst_m, drive.off_m());
    ++followed.looks;
    if (!located.fix) continue;
    ++followed.fixes;
    if (drive.nees(*located.fix) <= chi2_95) ++followed.within;
  }
  followed.mean_m /= followed.looks;
  followed.jump_m = drive.largest_jump_m();
  followed.switches = drive.switches();
  return followed;
}

TEST(TopometricLocate, FollowsARobotOverChartsWithoutAJump) {
  int within = 0;
  int fixes = 0;
  for (const std::uint64_t seed : {1001U, 1002U, 1003U}) {
    const Followed followed = follow({}, seed);
    EXPECT_LE(followed.mean_m, 0.05) << seed;
    EXPECT_LE(followed.worst_m, 0.12) << seed;
    EXPECT_LE(followed.jump_m, 0.001) << seed;
    EXPECT_GE(followed.switches, 4);
    EXPECT_GE(followed.fixes, followed.looks * 95 / 100);
    within += followed.within;
    fixes += followed.fixes;
  }
  const double share = static_cast<double>(within) / fixes;
  RecordProperty("within_95", std::to_string(share));
  EXPECT_GE(share, 0.85) << "of fixes within their own 95 % ellipse";
}

TEST(TopometricLocate, FollowsByTheScanAlone) {
  for (const std::uint64_t seed : {1001U, 1002U}) {
    const Followed followed = follow(scan_only(), seed);
    EXPECT_LE(followed.mean_m, 0.08) << seed;
    EXPECT_LE(followed.jump_m, 0.001) << seed;
    EXPECT_GE(followed.within, followed.fixes * 80 / 100) << seed;
  }
}

TEST(TopometricLocate, ABareCorridorTellsNothingAlongItself) {
  const MadeSite site = bare_corridor();
  const TaughtSite taught = taught_straight(site, {-5.0, 0.0, 0.0}, 10.0);
  LocalisedDrive drive(site, taught, scan_only(), 1001);
  drive.begin({-3.0, 0.0, 0.0}, {-3.0, 0.0, 0.0}, 0.15, 0.03);
  for (int i = 0; i < 40; ++i) drive.next({0.1, 0.0, -drive.estimate().heading});
  const Eigen::Matrix3d covariance = drive.belief().estimate().covariance;
  EXPECT_GT(std::sqrt(covariance(0, 0)), 0.09) << "about as uncertain along as it began";
  EXPECT_LT(std::sqrt(covariance(1, 1)), 0.05) << "walls tell how far aside";
}

TEST(TopometricLocate, FeaturesTellWhereABareCorridorDoesNot) {
  MadeSite site = bare_corridor();
  site.add_landmarks(0.3, 5);
  const TaughtSite taught = taught_straight(site, {-5.0, 0.0, 0.0}, 10.0);
  LocalisedDrive drive(site, taught, {}, 1001);
  drive.begin({-3.0, 0.0, 0.0}, {-3.2, 0.0, 0.0}, 0.15, 0.03);
  for (int i = 0; i < 20; ++i) drive.next({0.1, 0.0, -drive.estimate().heading});
  EXPECT_LT(drive.off_m(), 0.05);
  EXPECT_LT(std::sqrt(drive.belief().estimate().covariance(0, 0)), 0.05);
}

TEST(TopometricLocate, AGuessTakesFeaturesToBecomeAFix) {
  Metric2 guess;
  guess.covariance = Eigen::Vector3d(0.25, 0.25, 0.09).asDiagonal();
  for (const bool has_landmarks : {false, true}) {
    MadeSite site = bare_corridor();
    if (has_landmarks) site.add_landmarks(0.3, 5);
    const TaughtSite taught = taught_straight(site, {}, 6.0);
    const Topometric method = made_method();
    const TopometricChart chart = method.chart(taught.around(4));
    Random random(3);
    const TopometricContent seen = site.view_from({2.2, 0.0, 0.0}, random);
    auto belief = method.begin(chart, {TaughtSite::id(4), guess, 0.0});
    bool has_fix = false;
    for (int i = 0; i < 3; ++i) {
      auto located = method.locate(chart, std::move(belief), {Metric2{{0.0, 0.0, 0.02}}, true, {}}, seen);
      has_fix = has_fix || located.fix.has_value();
      belief = std::move(located.belief);
    }
    EXPECT_EQ(has_fix, has_landmarks);
  }
}

TEST(TopometricLocate, DrivesThroughTheDarkAndFindsItselfAgain) {
  const MadeSite site = niched_corridor();
  const TaughtSite taught = taught_straight(site, {}, 18.0);
  LocalisedDrive drive(site, taught, {}, 1004);
  drive.begin({}, {}, 0.05, 0.03);
  for (int i = 0; i < 20; ++i) drive.next({0.1, 0.0, 0.0});
  for (int i = 0; i < 10; ++i) {
    const auto located = drive.next({0.1, 0.0, 0.0}, true);
    ASSERT_FALSE(located.fix);
    ASSERT_EQ(located.refusals.front().reason, "no_scan");
  }
  const double blind_sigma_m = std::sqrt(drive.belief().estimate().covariance(0, 0));
  EXPECT_GT(blind_sigma_m, 0.03);
  for (int i = 0; i < 5; ++i) drive.next({0.1, 0.0, 0.0});
  EXPECT_LT(drive.off_m(), 0.06);
}

TEST(TopometricLocate, AKidnappedRobotIsNotSureOfAWrongPlace) {
  const MadeSite site = furnished_room();
  const TaughtSite taught = taught_straight(site, {}, 5.0);
  int wrong = 0;
  for (std::uint64_t seed = 1001; seed < 1011; ++seed) {
    LocalisedDrive drive(site, taught, {}, seed);
    drive.begin({4.0, 1.5, 2.5}, {0.0, 0.0, 0.0}, 0.05, 0.03);
    for (int i = 0; i < 15; ++i) {
      const auto located = drive.next({0.02, 0.0, 0.15});
      if (located.fix && (drive.of_fix(*located.fix).translation() - drive.truth().translation()).norm() > 0.5)
        ++wrong;
    }
  }
  EXPECT_LE(wrong, 7) << "of 150 looks";
}

TEST(TopometricLocate, NamesItsRefusals) {
  const MadeSite site = furnished_room();
  const TaughtSite taught = taught_straight(site, {}, 5.0);
  const Topometric method = made_method();
  const TopometricChart chart = method.chart(taught.around(4));
  Random random(3);
  const TopometricContent seen = site.view_from({2.0, 0.0, 0.0}, random);
  const Step standing{Metric2{}, true, {}};

  const auto elsewhere = method.begin(chart, {{ExperienceId{99}, 0}, Metric2{}, 0.0});
  auto located = method.locate(chart, elsewhere, standing, seen);
  EXPECT_FALSE(located.fix);
  EXPECT_EQ(located.refusals.front().reason, "no_particles");

  const auto here = method.begin(chart, {TaughtSite::id(4), Metric2{}, 0.0});
  located = method.locate(chart, here, standing, TopometricContent{});
  EXPECT_EQ(located.refusals.front().reason, "no_scan");

  Metric2 vague;
  vague.covariance = Eigen::Vector3d(4.0, 4.0, 1.0).asDiagonal();
  const TopometricContent blank;
  TopometricContent nothing_returned = blank;
  nothing_returned.scan = Scan{};
  located = method.locate(chart, method.begin(chart, {TaughtSite::id(4), vague, 0.0}), standing, nothing_returned);
  EXPECT_EQ(located.refusals.front().reason, "no_scan");

  const TopometricChart empty = method.chart(taught.around(4, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}));
  located = method.locate(empty, method.begin(empty, {TaughtSite::id(4), vague, 0.0}), standing, seen);
  ASSERT_FALSE(located.fix);
  EXPECT_EQ(located.refusals.front().reason, "spread");

  const Metric2 far{Pose2{20.0, 0.0, 0.0}};
  located = method.locate(empty, method.begin(empty, {TaughtSite::id(4), far, 0.0}), standing, seen);
  ASSERT_FALSE(located.fix);
  EXPECT_EQ(located.refusals.front().reason, "off_the_chart");
}

TEST(TopometricLocate, AFixStandsOnTheFloor) {
  const MadeSite site = furnished_room();
  const TaughtSite taught = taught_straight(site, {}, 5.0);
  LocalisedDrive drive(site, taught, {}, 1001);
  drive.begin({2.1, 0.1, 0.05}, {2.1, 0.1, 0.05}, 0.05, 0.03);
  const auto located = drive.next({});
  ASSERT_TRUE(located.fix);
  EXPECT_EQ(located.fix->place, TaughtSite::id(4));
  const auto& metric = std::get<Metric3>(located.fix->place_from_robot);
  EXPECT_EQ(metric.a_from_b.translation.z(), 0.0);
  EXPECT_LT(metric.covariance.matrix()(2, 2), 0.001);
  EXPECT_TRUE(check(located.fix->place_from_robot));
}

TEST(TopometricBelief, OverruledParticlesBeginAnewOthersStay) {
  const MadeSite site = furnished_room();
  const TaughtSite taught = taught_straight(site, {}, 5.0);
  LocalisedDrive drive(site, taught, {}, 1001);
  drive.begin({2.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, 0.05, 0.03);
  drive.next({0.1, 0.0, 0.0});
  const TopometricBelief before = drive.belief();
  const Pose2 here = taught.site_from_places[4].inverse() * drive.estimate();
  const Metric2 near{here * Pose2{0.03, 0.0, 0.0}, 1e-4 * Eigen::Matrix3d::Identity()};
  const auto stays = drive.method().believed(drive.chart(), before, {TaughtSite::id(4), near, 0.0});
  EXPECT_EQ(stays.estimate().chart_from_robot, before.estimate().chart_from_robot);
  EXPECT_EQ(stays.filter->particles().x, before.filter->particles().x);
  const Metric2 far{here * Pose2{1.0, 0.0, 0.0}, 1e-4 * Eigen::Matrix3d::Identity()};
  const auto anew = drive.method().believed(drive.chart(), before, {TaughtSite::id(4), far, 0.0});
  EXPECT_NEAR(anew.estimate().chart_from_robot.x, far.a_from_b.x, 1e-6);
}

TEST(TopometricBelief, CarriedParticlesKeepTheirSpreadAndTheirMotionSince) {
  const MadeSite site = furnished_room();
  const TaughtSite taught = taught_straight(site, {}, 5.0);
  LocalisedDrive drive(site, taught, {}, 1001);
  drive.begin({2.0, 0.0, 0.0}, {2.0, 0.0, 0.0}, 0.05, 0.03);
  drive.next({0.1, 0.0, 0.0});
  drive.next({0.04, 0.0, 0.0});  // less than an update asks for
  ASSERT_TRUE(drive.belief().since);
  const TopometricChart next = drive.method().chart(taught.around(8));
  const auto carried = drive.method().carried(next, {TaughtSite::id(8), Metric2{}, 0.0}, drive.belief());
  const Pose2 in_site = taught.site_from_places[8] * carried.estimate().chart_from_robot;
  EXPECT_NEAR(in_site.x, drive.estimate().x, 1e-6);
  EXPECT_NEAR(in_site.y, drive.estimate().y, 1e-6);
  EXPECT_TRUE(carried.estimate().covariance.isApprox(drive.belief().estimate().covariance));
  EXPECT_EQ(carried.filter->particles().size(), drive.belief().filter->particles().size());
}

}  // namespace
}  // namespace weft::agents
