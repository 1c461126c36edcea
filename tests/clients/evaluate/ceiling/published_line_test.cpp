#include "clients/evaluate/ceiling/published_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "clients/evaluate/ceiling/frames/recording.hpp"
#include "clients/evaluate/ceiling/line_trials.hpp"
#include "clients/evaluate/ceiling/true_heights.hpp"

namespace weft::evaluate::ceiling {
namespace {

TEST(PublishedLaw, GoesStraightWithinTheGapAndTurnsBackBeyondIt) {
  EXPECT_EQ(published_command(9.9, 0.4).angular_rad_s, 0.0);
  EXPECT_EQ(published_command(-9.9, 0.4).angular_rad_s, 0.0);
  EXPECT_LT(published_command(10.1, 0.4).angular_rad_s, 0.0) << "left of the line it turns right";
  EXPECT_GT(published_command(-10.1, 0.4).angular_rad_s, 0.0);
  EXPECT_EQ(published_command(50.0, 0.4), published_command(11.0, 0.4)) << "all or nothing";
  EXPECT_GT(published_command(50.0, 0.4).linear_m_s, published_command(0.0, 0.4).linear_m_s);
}

TEST(PublishedLaw, ErrorsAreRmsAndLargest) {
  const BesideErrors errors = errors_of({{0.0, 0.3}, {1.0, -0.4}});
  EXPECT_NEAR(errors.rms_m, std::sqrt(0.125), 1e-12);
  EXPECT_NEAR(errors.worst_m, 0.4, 1e-12);
  EXPECT_TRUE(std::isnan(errors_of({}).rms_m));
}

TEST(MiddleOfView, LiesAboveACameraThatLooksUpAndAsideOfOneThatLeans) {
  agents::CameraModel camera = straight_up({});
  EXPECT_NEAR(middle_of_view(camera, 5.0).norm(), 0.0, 1e-9);
  const double tilt = 2.0 * std::numbers::pi / 180.0;
  camera.robot_from_camera.rotation =
      Eigen::Quaterniond(Eigen::AngleAxisd(tilt, Eigen::Vector3d::UnitY())) * camera.robot_from_camera.rotation;
  EXPECT_NEAR(middle_of_view(camera, 6.5).x(), 6.4 * std::tan(tilt), 1e-9);
}

TEST(MiddleOfView, IsNoPlaceOfTheRobotOnceAnotherCameraLeans) {
  agents::CameraModel leans = straight_up({});
  leans.robot_from_camera.rotation =
      Eigen::Quaterniond(Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitY())) * leans.robot_from_camera.rotation;
  const PlaceId place{ExperienceId{1}, 0};
  floor::Trace trace;
  floor::Moment moment;
  moment.fix = floor::FixSeen{place, {}, {}};
  trace.moments.push_back(moment);
  const std::map<PlaceId, Pose2> truth = {{place, Pose2{}}};
  const agents::CameraModel straight = straight_up({});
  EXPECT_NEAR(centroid_rms_m(trace, truth, straight, straight, 5.1), 0.0, 1e-9);
  EXPECT_NEAR(centroid_rms_m(trace, truth, straight, leans, 5.1), 5.0 * std::tan(0.1), 1e-9);
  EXPECT_TRUE(std::isnan(centroid_rms_m({}, truth, straight, leans, 5.1)));
}

TEST(UpperQuartile, IsNotExceededByThreeQuarters) {
  EXPECT_EQ(upper_quartile({4.0, 1.0, 3.0, 2.0}), 3.0);
  EXPECT_EQ(upper_quartile({7.0}), 7.0);
  EXPECT_TRUE(std::isnan(upper_quartile({})));
}

}  // namespace
}  // namespace weft::evaluate::ceiling
