#include "clients/evaluate/floor/alignment.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "clients/evaluate/floor/measures.hpp"
#include "tests/clients/evaluate/floor/driven_trace.hpp"

namespace weft::evaluate::floor {
namespace {

/// Holds a bend, and the same one as a tilted tracker sees it whose body is turned by 0.5 rad.
struct Bent {
  Trace trace = straight_trace(0.5, 4.0);
  formats::Trajectory trajectory;
  Bent() {
    const Pose3 world_from_start{Eigen::Quaterniond(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized())),
                                 {5.0, -2.0, 1.0}};
    const Eigen::Quaterniond turned(Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitZ()));
    Pose2 pose;
    for (Moment& moment : trace.moments) {
      pose = pose * se2_exp({0.5 / 30.0, 0.0, 0.01});
      moment.start_from_robot = pose;
      moment.site_from_robot = {};
      const Eigen::Quaterniond yaw(Eigen::AngleAxisd(pose.heading, Eigen::Vector3d::UnitZ()));
      trajectory.samples.push_back({moment.sensor_s, world_from_start * Pose3{yaw * turned, {pose.x, pose.y, 0.0}}});
    }
  }
};

TEST(FloorAlignment, FindsTheFrameOfATrackerAndTheTurnOfItsBody) {
  const Bent bent;
  const auto associated = associate(bent.trace, bent.trajectory);
  ASSERT_TRUE(associated.has_value());
  EXPECT_NEAR(associated->rmse_m, 0.0, 1e-6);
  EXPECT_NEAR(associated->out_of_plane_m, 0.0, 1e-6);
  EXPECT_NEAR(associated->heading_offset_rad, -0.5, 1e-6);
  const Moment& last = associated->trace.moments.back();
  EXPECT_NEAR(last.site_from_robot.x, last.start_from_robot.x, 1e-6);
  EXPECT_NEAR(wrap_angle(last.site_from_robot.heading - last.start_from_robot.heading), 0.0, 1e-6);
  const Trace again = in_frame_of(*associated, bent.trace, bent.trajectory);
  ASSERT_EQ(again.moments.size(), associated->trace.moments.size());
  EXPECT_NEAR(again.moments[50].site_from_robot.y, associated->trace.moments[50].site_from_robot.y, 1e-9);
}

TEST(FloorAlignment, ScaleIsNotAlignedAway) {
  Bent bent;
  for (Moment& moment : bent.trace.moments) {
    moment.start_from_robot.x *= 1.1;
    moment.start_from_robot.y *= 1.1;
  }
  const auto associated = associate(bent.trace, bent.trajectory);
  ASSERT_TRUE(associated.has_value());
  EXPECT_NEAR(speed_error(associated->trace).percent, 10.0, 0.5);
  EXPECT_GT(associated->rmse_m, 0.02);
}

TEST(FloorAlignment, BetweenSamplesAndNotAcrossGaps) {
  formats::Trajectory trajectory;
  for (const double t : {1.0, 1.1, 2.0}) {
    trajectory.samples.push_back({t, {Eigen::Quaterniond::Identity(), {t, 0.0, 0.0}}});
  }
  EXPECT_NEAR(at_time(trajectory, 1.05)->translation.x(), 1.05, 1e-9);
  EXPECT_NEAR(at_time(trajectory, 2.0)->translation.x(), 2.0, 1e-9);
  EXPECT_FALSE(at_time(trajectory, 1.5).has_value());
  EXPECT_FALSE(at_time(trajectory, 0.9).has_value());
  EXPECT_FALSE(at_time(trajectory, 2.1).has_value());
}

TEST(FloorAlignment, TooLittleIsNone) {
  Bent bent;
  bent.trajectory.samples.resize(5);
  EXPECT_FALSE(associate(bent.trace, bent.trajectory).has_value());
}

}  // namespace
}  // namespace weft::evaluate::floor
