#include "agents/perception/corner_tracks.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "agents/perception/planar_motion.hpp"
#include "core/random.hpp"
#include "tests/support/flat_floor.hpp"

namespace weft::agents {
namespace {

class CornerTracks : public testing::Test {
 protected:
  test::FlatFloor floor_ = test::FlatFloor::procedural(21, 4.0, 3.0);
  CameraModel camera_ = test::paper_camera();
  test::FloorCamera eye_{camera_};
};

TEST_F(CornerTracks, CornersAreSpreadAndWithinTheBorder) {
  const Image image = eye_.render(floor_, {0.8, 1.5, 0.0}, {}, {});
  const auto corners = find_corners(prepare_tracking(image, 13, 3), CornerConfig{});
  EXPECT_EQ(corners.size(), 160U);
  int left = 0;
  int top = 0;
  for (const Eigen::Vector2d& c : corners) {
    EXPECT_GE(c.minCoeff(), 12.0);
    left += c.x() < 376.0 ? 1 : 0;
    top += c.y() < 240.0 ? 1 : 0;
  }
  EXPECT_NEAR(left, 80, 30);
  EXPECT_NEAR(top, 80, 30);
}

TEST_F(CornerTracks, FollowTheFloorToAFractionOfAPixel) {
  PlanarState truth;
  truth.a_from_b = {0.02, 0.002, 0.01};
  test::Shot second;
  second.seed = 2;
  const Pose2 start{0.8, 1.5, 0.2};
  const TrackingImage a = prepare_tracking(eye_.render(floor_, start, {}, {}), 13, 3);
  const TrackingImage b = prepare_tracking(eye_.render(floor_, start * truth.a_from_b, {}, second), 13, 3);
  const auto corners = find_corners(a, CornerConfig{});
  const auto tracks = track_corners(a, b, corners, corners);
  std::vector<double> errors;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Reprojection there = reproject(camera_, camera_, truth, normalised_from_pixel(camera_, corners[i]));
    if (tracks[i].found) errors.push_back((tracks[i].pixel - pixel_from_normalised(camera_, there.in_b)).norm());
  }
  ASSERT_GT(errors.size(), 100U);
  std::sort(errors.begin(), errors.end());
  EXPECT_LT(errors[errors.size() / 2], 0.15);
}

/// Renders a pale floor whose grey values rise and fall gently, a few marks on it.
Image soft_floor(double brightness_at_right) {
  constexpr int width = 320;
  constexpr int height = 240;
  Random random(5);
  std::vector<Eigen::Vector3d> marks;
  for (int i = 0; i < 400; ++i)
    marks.emplace_back(random.uniform(0.0, width), random.uniform(0.0, height), random.uniform(-20.0, 20.0));
  auto pixels = std::make_shared<Bytes>();
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      double grey = 120.0 + 15.0 * std::sin(0.06 * u + 0.03 * v);
      for (const Eigen::Vector3d& mark : marks) {
        const double near = (mark.head<2>() - Eigen::Vector2d(u, v)).squaredNorm();
        if (near < 100.0) grey += mark.z() * std::exp(-0.5 * near / 4.0);
      }
      const double light = 1.0 + brightness_at_right * u / width;
      pixels->push_back(static_cast<std::uint8_t>(std::lround(std::clamp(light * grey, 0.0, 255.0))));
    }
  }
  return {width, height, pixels};
}

TEST_F(CornerTracks, LightThatChangesIsNoMotion) {
  const TrackingImage before = prepare_tracking(soft_floor(0.0), 13, 3);
  const TrackingImage after = prepare_tracking(soft_floor(0.06), 13, 3);
  CornerConfig few;
  few.count = 60;
  const auto corners = find_corners(before, few);
  ASSERT_EQ(corners.size(), 60U);
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  double squares = 0.0;
  const auto tracks = track_corners(before, after, corners, corners);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    ASSERT_TRUE(tracks[i].found);
    sum += tracks[i].pixel - corners[i];
    squares += (tracks[i].pixel - corners[i]).squaredNorm();
  }
  EXPECT_LT(std::sqrt(squares / 60.0), 0.1);
  EXPECT_LT((sum / 60.0).norm(), 0.02);
}

TEST_F(CornerTracks, AWindowIsCentredOnWhatItShows) {
  // Joints of tiles, 40 pixels apart: a window that grows by 3 % moves as its joints do.
  constexpr int width = 320;
  constexpr int height = 240;
  const auto jointed = [](double scale) {
    Random random(9);
    auto pixels = std::make_shared<Bytes>();
    for (int v = 0; v < height; ++v)
      for (int u = 0; u < width; ++u) {
        const double x = std::abs(std::remainder((u - 160.0) / scale - 7.0, 40.0));
        const double y = std::abs(std::remainder((v - 120.0) / scale - 11.0, 40.0));
        const double dark = 60.0 * std::max(std::exp(-0.5 * x * x), std::exp(-0.5 * y * y));
        pixels->push_back(static_cast<std::uint8_t>(std::lround(150.0 - dark + 0.5 * random.normal())));
      }
    return Image{width, height, pixels};
  };
  constexpr double grown = 1.03;
  const TrackingImage before = prepare_tracking(jointed(1.0), 13, 2);
  const TrackingImage after = prepare_tracking(jointed(grown), 13, 2);
  CornerConfig some;
  some.count = 30;
  const auto corners = find_corners(before, some);
  std::vector<Eigen::Vector2d> expected;
  const Eigen::Vector2d middle(160.0, 120.0);
  for (const Eigen::Vector2d& corner : corners) expected.emplace_back(middle + grown * (corner - middle));
  const auto tracks = track_corners(before, after, corners, expected);
  const auto counts = counts_at(before, corners, 0.5);
  double squares = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    squares += (counts[i] * (tracks[i].pixel - expected[i])).squaredNorm();
  ASSERT_GT(corners.size(), 10U);
  EXPECT_LT(std::sqrt(squares / static_cast<double>(corners.size())), 0.09);
}

/// Renders stripes at `angle_rad`: grey values change across them alone.
Image striped(double angle_rad, double noise) {
  constexpr int width = 64;
  Random random(2);
  auto pixels = std::make_shared<Bytes>();
  for (int v = 0; v < width; ++v)
    for (int u = 0; u < width; ++u)
      pixels->push_back(static_cast<std::uint8_t>(
          std::lround(120.0 + 30.0 * std::sin(0.6 * (std::cos(angle_rad) * u + std::sin(angle_rad) * v)) +
                      noise * random.normal())));
  return {width, width, pixels};
}

TEST_F(CornerTracks, AlongAnEdgeATrackHardlyCounts) {
  for (const double angle : {0.0, 0.5, 1.57, 2.5}) {
    const Eigen::Vector2d across(std::cos(angle), std::sin(angle));
    const Eigen::Vector2d along(-across.y(), across.x());
    const TrackingImage image = prepare_tracking(striped(angle, 2.0), 13, 2);
    const Eigen::Matrix2d counts = counts_at(image, {{32.0, 32.0}}, 2.0).front();
    EXPECT_NEAR((counts * across).norm(), 1.0, 0.02) << angle;
    EXPECT_LT((counts * along).norm(), 0.05) << angle;
  }
}

TEST_F(CornerTracks, OnASpotATrackCountsEitherWay) {
  const TrackingImage image = prepare_tracking(soft_floor(0.0), 13, 3);
  CornerConfig few;
  few.count = 20;
  for (const Eigen::Matrix2d& counts : counts_at(image, find_corners(image, few), 0.0)) {
    EXPECT_TRUE(counts.isApprox(counts.transpose()));
    EXPECT_NEAR(counts.operatorNorm(), 1.0, 1e-9);
    EXPECT_GT(std::abs(counts.determinant()), 0.2);
  }
}

TEST_F(CornerTracks, AnImageIsWholeOrNot) {
  EXPECT_FALSE(is_whole(Image{}));
  EXPECT_FALSE(is_whole({4, 4, std::make_shared<const Bytes>(15)}));
  EXPECT_TRUE(is_whole({4, 4, std::make_shared<const Bytes>(16)}));
}

TEST_F(CornerTracks, ASmallImageHasNoCornersEither) {
  for (const int width : {1, 2, 3, 5, 17, 24}) {
    const auto size = static_cast<std::size_t>(width) * static_cast<std::size_t>(width);
    const Image small{width, width, std::make_shared<const Bytes>(size)};
    EXPECT_TRUE(find_corners(prepare_tracking(small, 13, 2), CornerConfig{}).empty()) << width;
  }
}

TEST_F(CornerTracks, APlainFloorHasNoCorners) {
  test::Shot quiet;
  quiet.noise = 0.0;
  const Image image = eye_.render(test::FlatFloor::blank(4.0, 3.0), {0.8, 1.5, 0.0}, {}, quiet);
  EXPECT_TRUE(find_corners(prepare_tracking(image, 13, 3), CornerConfig{}).empty());
}

}  // namespace
}  // namespace weft::agents
