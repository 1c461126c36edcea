#include <gtest/gtest.h>

#include <cmath>

#include "agents/methods/floor/floor.hpp"
#include "tests/support/floor_drive.hpp"

namespace weft::agents {
namespace {

// Bounds: with the true calibration runs show 0.03 to 0.18 % of distance and 0.001 to 0.03 degrees a metre over eight
// seeds; a robot's needs are 0.5 % and 0.05 degrees. Twice what was seen is allowed.
constexpr double kDistance = 0.004;
constexpr double kHeadingDegPerM = 0.05;

class FloorOdometry : public testing::Test {
 protected:
  static Floor make(const CameraModel& given, const FloorConfig& config = {}) {
    auto made = Floor::make(config, given);
    if (!made) throw std::runtime_error(made.error().message);
    return *made;
  }
  static void SetUpTestSuite() {
    floor_ = std::make_unique<test::FlatFloor>(test::FlatFloor::procedural(3, 7.0, 5.0));
    eye_ = std::make_unique<test::FloorCamera>(test::paper_camera());
  }
  static void TearDownTestSuite() {
    floor_.reset();
    eye_.reset();
  }
  static inline std::unique_ptr<test::FlatFloor> floor_;
  static inline std::unique_ptr<test::FloorCamera> eye_;
};

TEST_F(FloorOdometry, StraightWithVibration) {
  const test::Driven run = test::drive(make(test::paper_camera()), *eye_, *floor_, {});
  EXPECT_EQ(run.blind, 0);
  EXPECT_LT(std::abs(run.distance_error()), kDistance);
  EXPECT_LT(run.heading_error_deg_per_m(), kHeadingDegPerM);
}

TEST_F(FloorOdometry, IsTheRobotsWhateverItRocksAbout) {
  for (const double height : {0.0, 0.3, 0.6}) {
    test::Drive how;
    how.rocks_about_m = height;
    const test::Driven run = test::drive(make(test::paper_camera()), *eye_, *floor_, how);
    EXPECT_NEAR(run.odometry.rocking_centre->height_m(), height, 0.1);
    EXPECT_LT(run.step_off_m, 0.0003) << "a camera that rocks about itself would seem to go 0.7 mm more or less";
  }
}

TEST_F(FloorOdometry, OneMetreASecondBlurredWithoutWheels) {
  test::Drive how;
  how.speed_m_s = 1.0;
  how.duration_s = 3.0;
  how.blur = true;
  how.wheels = false;
  const test::Driven run = test::drive(make(test::paper_camera()), *eye_, *floor_, how);
  EXPECT_EQ(run.blind, 0);
  EXPECT_LT(std::abs(run.distance_error()), kDistance);
  EXPECT_LT(run.heading_error_deg_per_m(), kHeadingDegPerM);
}

TEST_F(FloorOdometry, CurveWithDroppedFrames) {
  test::Drive how;
  how.speed_m_s = 0.5;
  how.turn_rad_s = 0.4;
  how.drop_share = 0.05;
  how.seed = 2;
  const test::Driven run = test::drive(make(test::paper_camera()), *eye_, *floor_, how);
  ASSERT_GT(run.blind, 0);
  EXPECT_EQ(run.reasons.at("dropped_frame"), run.blind);
  EXPECT_LT(run.off_m() / run.length_m, kDistance) << "the next view takes the blind step's error back";
  EXPECT_LT(run.heading_error_deg_per_m(), kHeadingDegPerM);
}

TEST_F(FloorOdometry, HalfTheLight) {
  test::Drive how;
  how.shot.gain = 0.5;
  how.duration_s = 3.0;
  const test::Driven run = test::drive(make(test::paper_camera()), *eye_, *floor_, how);
  EXPECT_EQ(run.blind, 0);
  EXPECT_LT(std::abs(run.distance_error()), kDistance);
}

TEST_F(FloorOdometry, AWrongCalibrationCostsAboutItsScale) {
  // 0.5 % by the height, 0.3 % by the focal length, up to 1.1 % by the pitch before it is estimated (1 sigma each,
  // with tails, as drawn here).
  FloorConfig told;
  told.measured_scale = std::hypot(0.005, 0.003);
  for (const std::uint64_t seed : {1U, 2U}) {
    test::Drive how;
    how.duration_s = 3.0;
    how.seed = seed;
    const test::Driven run =
        test::drive(make(test::miscalibrated(test::paper_camera(), seed), told), *eye_, *floor_, how);
    EXPECT_EQ(run.blind, 0);
    EXPECT_LT(std::abs(run.distance_error()), 0.025);
    // The covariance knows: within 3 sigma along the path.
    const Eigen::Vector3d error = se2_log(run.seen_motion.inverse() * run.true_motion);
    EXPECT_LT(std::abs(error.x()), 3.0 * std::sqrt(run.covariance(0, 0)));
  }
}

TEST_F(FloorOdometry, StandingStillDoesNotDrift) {
  test::Drive how;
  how.speed_m_s = 0.0;
  how.duration_s = 1.0;
  const test::Driven run = test::drive(make(test::paper_camera()), *eye_, *floor_, how);
  EXPECT_EQ(run.blind, 0);
  EXPECT_LT(run.seen_motion.translation().norm(), 0.0015);  // vibration of the last frame, nothing more
  EXPECT_LT(std::abs(run.seen_motion.heading), 0.0005);
}

TEST_F(FloorOdometry, ABlankFloorIsBlind) {
  const test::FlatFloor blank = test::FlatFloor::blank(7.0, 5.0);
  test::Drive how;
  how.duration_s = 0.5;
  how.shot.noise = 1.0;
  const test::Driven run = test::drive(make(test::paper_camera()), *eye_, blank, how);
  EXPECT_EQ(run.blind, 15);
  EXPECT_NEAR(run.seen_motion.x, 1.03 * run.true_motion.x, 1e-9) << "integrates the wheels";
}

class FloorObserve : public FloorOdometry {
 protected:
  View view_at(const Pose2& floor_from_robot, std::uint64_t seed) const {
    test::Shot shot;
    shot.seed = seed;
    View view;
    view.frame = seed;
    view.data = eye_->render(*floor_, floor_from_robot, {}, shot);
    return view;
  }
  static Motion wheels(double metres) {
    Motion motion;
    motion.elapsed = from_seconds(1.0 / 30.0);
    motion.wheels = WheelStep{metres, 0.0};
    return motion;
  }
  Floor method_ = make(test::paper_camera());
  Floor::Odometry odometry_;
};

TEST_F(FloorObserve, TheFirstViewIsBlindByName) {
  const View view = view_at({1.2, 2.0, 0.0}, 1);
  const Step step = method_.observe(odometry_, &view, wheels(0.0));
  EXPECT_FALSE(step.seen);
  EXPECT_EQ(step.blind_reason, "first_view");
}

TEST_F(FloorObserve, ACroppedImageIsTheWrongSize) {
  View view = view_at({1.2, 2.0, 0.0}, 1);
  std::get<Image>(view.data).height = 470;  // header and pixels disagree: a damaged file
  EXPECT_EQ(method_.observe(odometry_, &view, wheels(0.01)).blind_reason, "wrong_size");
  EXPECT_EQ(method_.extract(odometry_, view).error().reason, "wrong_size");
  view.data = Image{376, 240, std::make_shared<const Bytes>(376 * 240)};
  EXPECT_EQ(method_.observe(odometry_, &view, wheels(0.01)).blind_reason, "wrong_size");
  view.data = Image{};
  EXPECT_EQ(method_.observe(odometry_, &view, wheels(0.01)).blind_reason, "wrong_size");
  view.data = Payload{};
  EXPECT_EQ(method_.observe(odometry_, &view, wheels(0.01)).blind_reason, "not_an_image");
  EXPECT_EQ(method_.extract(odometry_, view).error().reason, "not_an_image");
}

TEST_F(FloorObserve, RecoversAfterADamagedImage) {
  const View first = view_at({1.2, 2.0, 0.0}, 1);
  View second = view_at({1.22, 2.0, 0.0}, 2);
  const View third = view_at({1.24, 2.0, 0.0}, 3);
  method_.observe(odometry_, &first, wheels(0.0));
  std::get<Image>(second.data).height = 100;
  Pose2 moved = planar(method_.observe(odometry_, &second, wheels(0.0206)).previous_from_current);
  const Step step = method_.observe(odometry_, &third, wheels(0.0206));
  EXPECT_TRUE(step.seen) << step.blind_reason;
  moved = moved * planar(step.previous_from_current);
  EXPECT_NEAR(moved.x, 0.04, 0.0008);
}

TEST_F(FloorObserve, AGrossDisagreementWithTheWheelsIsBlind) {
  const View first = view_at({1.2, 2.0, 0.0}, 1);
  const View second = view_at({1.21, 2.0, 0.0}, 2);
  method_.observe(odometry_, &first, wheels(0.0));
  const Step step = method_.observe(odometry_, &second, wheels(0.12));
  EXPECT_FALSE(step.seen);
  EXPECT_NEAR(planar(step.previous_from_current).x, 0.12, 1e-9);
}

TEST_F(FloorObserve, AJumpOfTheViewIsSeenByFeatures) {
  // 0.3 m are 40 % of the image; nothing says so but the view.
  const View first = view_at({1.2, 2.0, 0.0}, 1);
  const View second = view_at({1.5, 2.0, 0.04}, 2);
  Motion commanded;
  commanded.elapsed = from_seconds(1.0 / 30.0);
  commanded.command = {0.6, 0.0};
  method_.observe(odometry_, &first, commanded);
  const Step step = method_.observe(odometry_, &second, commanded);
  ASSERT_TRUE(step.seen) << step.blind_reason;
  EXPECT_EQ(odometry_.seen_by, Floor::SeenBy::features);
  EXPECT_EQ(odometry_.views_by[static_cast<std::size_t>(Floor::SeenBy::features)], 1U);
  EXPECT_NEAR(planar(step.previous_from_current).x, 0.3, 0.003);
  EXPECT_NEAR(planar(step.previous_from_current).heading, 0.04, 0.004);
}

TEST_F(FloorObserve, AFloorTooPaleForCornersIsSeenByItsGreyValues) {
  const test::FlatFloor pale = test::FlatFloor::procedural(3, 4.0, 4.0, 2.0);
  const auto blurred = [&](const Pose2& floor_from_robot, std::uint64_t seed) {
    test::Shot shot;
    shot.seed = seed;
    shot.blur = {0.03, 0.0, 0.0};
    shot.noise = 0.3;
    View view;
    view.frame = seed;
    view.data = eye_->render(pale, floor_from_robot, {}, shot);
    return view;
  };
  const View first = blurred({1.2, 2.0, 0.0}, 1);
  const View second = blurred({1.3, 2.0, 0.0}, 2);
  method_.observe(odometry_, &first, wheels(0.0));
  const Step step = method_.observe(odometry_, &second, wheels(0.103));
  ASSERT_TRUE(step.seen) << step.blind_reason;
  EXPECT_EQ(odometry_.seen_by, Floor::SeenBy::grey_values);
  EXPECT_NEAR(planar(step.previous_from_current).x, 0.1, 0.002);
}

TEST_F(FloorObserve, AFloorTooBlurredForCornersIsSeenByItsGreyValues) {
  const auto seen_with_blur = [&](double blur_m) {
    const View first = view_at({1.2, 2.0, 0.0}, 1);
    test::Shot shot;
    shot.seed = 2;
    shot.blur = {blur_m, 0.0, 0.0};
    View second;
    second.frame = 2;
    second.data = eye_->render(*floor_, {1.3, 2.0, 0.0}, {}, shot);
    Floor::Odometry odometry;
    method_.observe(odometry, &first, wheels(0.0));
    const Step step = method_.observe(odometry, &second, wheels(0.103));
    EXPECT_TRUE(step.seen) << step.blind_reason;
    EXPECT_NEAR(planar(step.previous_from_current).x, 0.1, 0.0015);
    return odometry.seen_by;
  };
  EXPECT_EQ(seen_with_blur(0.1), Floor::SeenBy::corners);
  EXPECT_EQ(seen_with_blur(0.2), Floor::SeenBy::grey_values);
}

TEST_F(FloorObserve, AnotherPlaceIsNotAMotion) {
  const View first = view_at({1.2, 1.6, 0.0}, 1);
  const View elsewhere = view_at({3.4, 3.2, 2.0}, 2);
  method_.observe(odometry_, &first, wheels(0.0));
  const Step step = method_.observe(odometry_, &elsewhere, wheels(0.01));
  EXPECT_FALSE(step.seen);
  EXPECT_NE(step.blind_reason, "");
}

}  // namespace
}  // namespace weft::agents
