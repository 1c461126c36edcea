#include "clients/evaluate/floor/measures.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/clients/evaluate/floor/driven_trace.hpp"

namespace weft::evaluate::floor {
namespace {

constexpr PlaceId kPlace{ExperienceId{1}, 0};
const std::map<PlaceId, Pose2> kAtOrigin = {{kPlace, {}}};

/// Adds a fix every `every` samples, off by `off` in the robot's frame.
void add_fixes(Trace& trace, std::size_t every, const Pose2& off) {
  for (std::size_t i = 0; i < trace.moments.size(); i += every) {
    const Pose2 measured = trace.moments[i].site_from_robot * off;
    trace.moments[i].fix = FixSeen{kPlace, measured, measured};
  }
}

TEST(FloorMeasures, SpeedErrorIsTheShareOfTheMeanSpeed) {
  Trace trace = straight_trace(0.5, 5.0);
  EXPECT_NEAR(speed_error(trace).percent, 0.0, 1e-9);
  for (Moment& moment : trace.moments) moment.start_from_robot.x *= 1.02;
  EXPECT_NEAR(speed_error(trace).percent, 2.0, 1e-6);
  for (Moment& moment : trace.moments) moment.sensor_s *= 0.98;
  EXPECT_NEAR(speed_error(trace).percent, 2.0, 1e-6);
  EXPECT_NEAR(speed_error(trace).stamped_percent, 100.0 * (1.02 / 0.98 - 1.0), 1e-6);
}

TEST(FloorMeasures, StandingHasNoSpeedError) {
  const Trace creeping = straight_trace(0.09, 1.0);
  EXPECT_TRUE(speed_windows(creeping).empty());
  EXPECT_TRUE(std::isnan(speed_error(creeping).percent));
}

TEST(FloorMeasures, ConsistencyComparesOdometryWithWhatFixesSay) {
  Trace trace = straight_trace(0.5, 5.0);
  add_fixes(trace, 6, {});
  EXPECT_NEAR(consistency_percent(fixed_stretches(trace, kAtOrigin)), 0.0, 1e-9);
  for (Moment& moment : trace.moments) moment.start_from_robot.x *= 1.01;
  const auto stretches = fixed_stretches(trace, kAtOrigin);
  EXPECT_GE(stretches.size(), 8U);
  EXPECT_NEAR(consistency_percent(stretches), 100.0 * (1.0 - 1.0 / 1.01), 1e-6);
  EXPECT_TRUE(std::isnan(consistency_percent({})));
}

TEST(FloorMeasures, BlindIsFromRightFixToRightFixWithBothEnds) {
  Trace trace = straight_trace(0.5, 3.0);
  const std::vector<double> none = blind_distances(trace, kAtOrigin);
  ASSERT_EQ(none.size(), 1U);
  EXPECT_NEAR(none.front(), 3.0, 1e-9);
  const auto fix_at = [&](std::size_t i, const Pose2& off) {
    const Pose2 measured = trace.moments[i].site_from_robot * off;
    trace.moments[i].fix = FixSeen{kPlace, measured, measured};
  };
  fix_at(60, {0.0, 0.04, 0.0});
  fix_at(90, {0.0, 0.06, 0.0});   // not right
  fix_at(100, {0.0, 0.0, 0.04});  // not right
  fix_at(120, {});
  const std::vector<double> two = blind_distances(trace, kAtOrigin);
  ASSERT_EQ(two.size(), 3U);
  EXPECT_NEAR(two[0], 1.0, 1e-9);
  EXPECT_NEAR(two[1], 1.0, 1e-9);
  EXPECT_NEAR(two[2], 1.0, 1e-9);
}

TEST(FloorMeasures, AFixIsWrongAsMeasuredOrAsBelieved) {
  Trace trace = straight_trace(0.5, 1.0);
  add_fixes(trace, 20, {0.09, 0.0, 0.05});
  EXPECT_EQ(fixes(trace), 4.0);
  EXPECT_EQ(wrong_fixes(trace, kAtOrigin), 0.0);
  trace.moments[20].fix->measured.y += 0.11;
  EXPECT_EQ(wrong_fixes(trace, kAtOrigin), 1.0);
  trace.moments[40].fix->believed.heading += 0.06;
  EXPECT_EQ(wrong_fixes(trace, kAtOrigin), 2.0);
}

TEST(FloorMeasures, StretchesComposeTheStepsCovariances) {
  Trace trace = straight_trace(0.6, 5.0);  // 2 cm a sample
  for (Moment& moment : trace.moments) {
    moment.start_from_robot.x *= 1.01;
    moment.step_covariance = Eigen::Vector3d(1e-6, 1e-6, 1e-8).asDiagonal();
  }
  const std::vector<Stretch> found = stretches(trace, 1.0);
  ASSERT_GE(found.size(), 38U);  // one a decimetre
  EXPECT_NEAR(found.front().off.x(), -0.01, 1e-3);
  EXPECT_NEAR(found.front().covariance(0, 0), 50e-6, 1.1e-6);
  EXPECT_NEAR(found.front().covariance(2, 2), 50e-8, 1.1e-8);
  // 10 mm off where 7 mm are one sigma: 1.41 sigma.
  EXPECT_NEAR(distances2(found).front(), 2.0, 0.1);
  EXPECT_TRUE(stretches(trace, 6.0).empty());
}

TEST(FloorMeasures, HeldIsTheShareWithinTheRegion) {
  EXPECT_NEAR(held_percent({1.0, 7.8, 7.9, 30.0}), 50.0, 1e-9);
  EXPECT_TRUE(std::isnan(held_percent({})));
}

TEST(FloorMeasures, PathErrorsLeaveOutTheJoin) {
  const TaughtPath path(straight_trace(0.5, 6.0));
  Trace repeated = straight_trace(0.5, 6.0);
  for (Moment& moment : repeated.moments) {
    const double x = moment.site_from_robot.x;
    moment.site_from_robot.y = x < 0.9 ? 0.2 : 0.01;
    moment.site_from_robot.heading = x < 0.9 ? 0.3 : -0.02;
  }
  const PathErrors errors = path_errors(off_path(repeated, path));
  EXPECT_NEAR(errors.lateral_rmse_m, 0.01, 1e-6);
  EXPECT_NEAR(errors.lateral_worst_m, 0.01, 1e-6);
  EXPECT_NEAR(errors.heading_rms_rad, 0.02, 1e-6);
  EXPECT_TRUE(std::isnan(path_errors({}).lateral_worst_m));
}

}  // namespace
}  // namespace weft::evaluate::floor
