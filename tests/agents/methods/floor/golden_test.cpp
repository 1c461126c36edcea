#include <gtest/gtest.h>

#include <cstring>
#include <opencv2/core.hpp>
#include <span>

#include "agents/methods/floor/floor.hpp"
#include "tests/support/floor_drive.hpp"

/// Tests that what `floor` finds stays the same to the last bit, unless it is meant to change: then the hashes below
/// are written anew with the reason in the commit.
namespace weft::agents {
namespace {

/// Hashes numbers by their bytes (FNV-1a, 64 bits).
class BitHash {
 public:
  void add(std::span<const std::uint8_t> bytes) {
    for (const std::uint8_t byte : bytes) hash_ = (hash_ ^ byte) * 0x100000001B3ULL;
  }
  template <class Number>
  requires std::is_arithmetic_v<Number>
  void add(Number number) {
    std::array<std::uint8_t, sizeof(Number)> bytes{};
    std::memcpy(bytes.data(), &number, sizeof(Number));
    add(bytes);
  }
  void add(const Relation& relation) {
    const Pose2 pose = planar(relation);
    for (const double v : {pose.x, pose.y, pose.heading}) add(v);
    add(planar_covariance(relation));
  }
  void add(const Eigen::Matrix3d& matrix) {
    for (const double v : matrix.reshaped()) add(v);
  }
  void add(const OrRefusal<Related>& related) {
    if (!related) {
      add(related.error().measured);
      return;
    }
    add(related->a_from_b);
    add(related->inliers);
    add(related->overlap);
    add(related->residual);
    for (const Diagnostic& diagnostic : related->diagnostics) {
      add(diagnostic.value);
      add(diagnostic.sigma);
    }
  }
  std::uint64_t value() const { return hash_; }

 private:
  std::uint64_t hash_ = 0xCBF29CE484222325ULL;
};

/// Keeps OpenCV to the instructions that every processor has, which otherwise differ in the last bits.
struct FloorGolden : testing::Test {
  FloorGolden() { cv::setUseOptimized(false); }
  ~FloorGolden() override { cv::setUseOptimized(was_optimised_); }

  FloorContent content(const Floor& by, const Pose2& at, const test::Shot& shot,
                       const Attitude& attitude = {}) const {
    auto seen = test::look(by, eye_, floor_, at, attitude, shot);
    if (!seen) throw std::runtime_error(std::string(seen.error().reason));
    return *by.decode(by.encode(*seen));
  }

 private:
  bool was_optimised_ = cv::useOptimized();

 protected:
  test::FlatFloor floor_ = test::FlatFloor::procedural(9, 7.0, 5.0);
  test::FloorCamera eye_{test::paper_camera()};
  Floor method_ = *Floor::make({}, test::paper_camera());
};

TEST_F(FloorGolden, Contents) {
  const FloorContent seen = content(method_, {2.0, 2.5, 0.4}, {});
  BitHash hash;
  hash.add(method_.encode(seen));
  const std::optional<Signature> signature = method_.sign(seen);
  ASSERT_TRUE(signature);
  for (const float word : *signature) hash.add(word);
  EXPECT_EQ(hash.value(), 0x827716DBD0CEBD65ULL);
}

TEST_F(FloorGolden, Relations) {
  const Floor other = *Floor::make({}, test::miscalibrated(test::paper_camera(), 11));
  const Pose2 at{2.0, 2.5, 0.4};
  const FloorContent a = content(method_, at, {});
  BitHash hash;
  for (const Pose2& a_from_b : {Pose2{0.25, 0.05, 0.05}, Pose2{-0.3, 0.0, -0.2}, Pose2{1.8, 0.0, 3.14159}}) {
    const FloorContent b = content(other, at * a_from_b, {.blur = {}, .seed = 7}, {0.0008, -0.0006, 0.001});
    const Relation guess = Metric2{a_from_b * Pose2{0.03, -0.04, 0.05}, Eigen::Matrix3d::Zero()};
    const auto guided = method_.relate(a, b, guess);
    EXPECT_TRUE(guided);
    hash.add(guided);
    hash.add(method_.relate(a, b, std::nullopt));
  }
  EXPECT_EQ(hash.value(), 0x8DA385F86BF72136ULL);
}

TEST_F(FloorGolden, Odometry) {
  test::Drive how;
  how.duration_s = 2.0;
  how.turn_rad_s = 0.2;
  how.frames_per_second = 15.0;
  how.drop_share = 0.1;
  const test::Driven run = test::drive(method_, eye_, floor_, how);
  EXPECT_GT(run.odometry.views_by[static_cast<std::size_t>(Floor::SeenBy::corners)], 15U);
  BitHash hash;
  for (const double v : {run.seen_motion.x, run.seen_motion.y, run.seen_motion.heading}) hash.add(v);
  hash.add(run.covariance);
  const MountTilt tilt = run.odometry.mount->tilt();
  for (const double v : {tilt.pitch_rad, tilt.roll_rad, run.odometry.rocking_centre->height_m()}) hash.add(v);
  EXPECT_EQ(hash.value(), 0xBAE2C6BE9D422A85ULL);
}

/// Tests a jump of half a metre, which is further than corners can be followed.
TEST_F(FloorGolden, OdometryByFeatures) {
  Floor::Odometry odometry;
  View view;
  view.data = eye_.render(floor_, {2.0, 2.5, 0.4}, {}, {});
  method_.observe(odometry, &view, {});
  view.frame = 1;
  view.data = eye_.render(floor_, Pose2{2.0, 2.5, 0.4} * Pose2{0.5, 0.05, 0.3}, {}, {.blur = {}, .seed = 2});
  Motion motion;
  motion.elapsed = from_seconds(1.0);
  motion.wheels = WheelStep{0.35, 0.15};
  const Step step = method_.observe(odometry, &view, motion);
  EXPECT_EQ(Floor::name_of(odometry.seen_by), "features") << step.blind_reason;
  BitHash hash;
  hash.add(step.previous_from_current);
  EXPECT_EQ(hash.value(), 0xA6108FF5853DB70DULL);
}

}  // namespace
}  // namespace weft::agents
