#pragma once
// A floor for tests of what looks at floors: flat, textured without repetition, seen through a known camera. Not the
// simulated camera of agents/bodies/sim, on purpose: a mistake would have to be made twice.
#include <cmath>
#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "agents/perception/attitude.hpp"
#include "agents/perception/camera_model.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/opencv_view.hpp"
#include "agents/perception/plane/geometry.hpp"
#include "core/random.hpp"

namespace weft::test {

/// Describes what differs between two looks at one floor.
struct Shot {
  double gain = 1.0;
  double noise = 2.0;       ///< grey levels
  double vignetting = 0.2;  ///< darker by this in the corners
  bool shadow = false;      ///< a hard edge across the floor, 60 % darker on one side
  Pose2 blur;               ///< motion while the shutter is open, robot frame
  std::uint64_t seed = 1;   ///< of the noise
};

/// Holds a grey texture over metres. Coordinates beyond it are mirrored: keep away from the rim.
class FlatFloor {
 public:
  static constexpr double metres_per_texel = 0.00125;

  static FlatFloor procedural(std::uint64_t seed, double length_m, double width_m, double contrast = 18.0) {
    cv::RNG rng(seed);
    const cv::Size size(static_cast<int>(length_m / metres_per_texel), static_cast<int>(width_m / metres_per_texel));
    cv::Mat sum = cv::Mat::zeros(size, CV_32F);
    for (const auto& [grain, weight] : {std::pair{3, 0.7}, {8, 0.8}, {25, 0.7}, {80, 0.8}, {300, 0.6}}) {
      cv::Mat coarse(size.height / grain + 2, size.width / grain + 2, CV_32F);
      rng.fill(coarse, cv::RNG::NORMAL, 0.0, weight);
      cv::Mat fine;
      cv::resize(coarse, fine, size, 0, 0, cv::INTER_CUBIC);
      sum += fine;
    }
    const int specks = static_cast<int>(length_m * width_m * 250.0);
    for (int i = 0; i < specks; ++i) {
      const cv::Point at(rng.uniform(0, size.width), rng.uniform(0, size.height));
      cv::circle(sum, at, rng.uniform(1, 6), cv::Scalar(rng.gaussian(3.0)), -1, cv::LINE_AA);
    }
    FlatFloor floor;
    sum.convertTo(floor.texture_, CV_8U, contrast / 1.6, 120.0);
    return floor;
  }

  static FlatFloor blank(double length_m, double width_m) {
    FlatFloor floor;
    floor.texture_ = cv::Mat(static_cast<int>(width_m / metres_per_texel),
                             static_cast<int>(length_m / metres_per_texel), CV_8U, cv::Scalar(120));
    return floor;
  }

  /// Makes a photograph into a floor without repetition: random crops of it, turned and feathered.
  static FlatFloor quilted(const cv::Mat& photograph, double metres_per_pixel, std::uint64_t seed, double length_m,
                           double width_m) {
    constexpr int patch = 360;
    cv::Mat source;
    const double scale = metres_per_pixel / metres_per_texel;
    cv::resize(photograph, source, {}, scale, scale, scale < 1.0 ? cv::INTER_AREA : cv::INTER_LINEAR);
    const int least = patch + 8;
    if (source.cols < least || source.rows < least)
      cv::copyMakeBorder(source, source, 0, std::max(0, least - source.rows), 0, std::max(0, least - source.cols),
                         cv::BORDER_REFLECT);
    cv::RNG rng(seed);
    const cv::Size size(static_cast<int>(length_m / metres_per_texel), static_cast<int>(width_m / metres_per_texel));
    const cv::Mat sum = cv::Mat::zeros(size.height + patch, size.width + patch, CV_32F);
    const cv::Mat weight = sum.clone();
    cv::Mat window;
    cv::createHanningWindow(window, {patch, patch}, CV_32F);
    window += 1e-3;
    for (int y = 0; y < size.height; y += patch / 2)
      for (int x = 0; x < size.width; x += patch / 2) {
        cv::Mat crop;
        source(cv::Rect(rng.uniform(0, source.cols - patch), rng.uniform(0, source.rows - patch), patch, patch))
            .convertTo(crop, CV_32F);
        if (const int turns = rng.uniform(0, 4); turns < 3) cv::rotate(crop, crop, turns);
        sum(cv::Rect(x, y, patch, patch)) += crop.mul(window);
        weight(cv::Rect(x, y, patch, patch)) += window;
      }
    const cv::Mat whole = sum / weight;
    FlatFloor floor;
    whole(cv::Rect(0, 0, size.width, size.height)).convertTo(floor.texture_, CV_8U);
    return floor;
  }

  /// Makes a floor that repeats one square of a procedural floor.
  static FlatFloor tiled(std::uint64_t seed, double tile_m, double length_m, double width_m) {
    const FlatFloor one = procedural(seed, tile_m, tile_m);
    FlatFloor floor;
    cv::repeat(one.texture_, static_cast<int>(std::ceil(width_m / tile_m)),
               static_cast<int>(std::ceil(length_m / tile_m)), floor.texture_);
    return floor;
  }

  double length_m() const { return texture_.cols * metres_per_texel; }
  double width_m() const { return texture_.rows * metres_per_texel; }

 private:
  FlatFloor() = default;
  cv::Mat texture_;
  friend class FloorCamera;
};

/// Renders views of a floor, or of the same as a ceiling, through a camera: exact geometry with the lens, filtered by
/// area (4 samples a pixel).
class FloorCamera {
 public:
  explicit FloorCamera(const agents::CameraModel& truth, double above_floor_m = 0.0)
      : truth_(truth), above_floor_m_(above_floor_m) {
    rays_.create(truth.height * down, truth.width * across, CV_32FC2);
    for (int r = 0; r < rays_.rows; ++r)
      for (int c = 0; c < rays_.cols; ++c) {
        const Eigen::Vector2d pixel((c + 0.5) / across - 0.5, (r + 0.5) / down - 0.5);
        const Eigen::Vector2d ray = agents::normalised_from_pixel(truth, pixel);
        rays_.at<cv::Vec2f>(r, c) = {static_cast<float>(ray.x()), static_cast<float>(ray.y())};
      }
    vignette_.create(truth.height, truth.width, CV_32F);
    for (int r = 0; r < truth.height; ++r)
      for (int c = 0; c < truth.width; ++c) {
        const double x = (c - truth.cx) / (0.5 * truth.width);
        const double y = (r - truth.cy) / (0.5 * truth.height);
        vignette_.at<float>(r, c) = static_cast<float>(0.5 * (x * x + y * y));
      }
  }

  agents::Image render(const FlatFloor& floor, const Pose2& floor_from_robot, const agents::Attitude& attitude,
                       const Shot& shot) const {
    const bool moving = shot.blur.translation().norm() > 1e-6 || std::abs(shot.blur.heading) > 1e-6;
    const int exposures = moving ? 3 : 1;
    cv::Mat light = cv::Mat::zeros(truth_.height, truth_.width, CV_32F);
    for (int i = 0; i < exposures; ++i) {
      const double share = exposures == 1 ? 0.0 : (i - 1) / 3.0;
      const Pose2 part{share * shot.blur.x, share * shot.blur.y, share * shot.blur.heading};
      cv::Mat once;
      look(floor, floor_from_robot * part, attitude, shot).convertTo(once, CV_32F, 1.0 / exposures);
      light += once;
    }
    light = light.mul(shot.gain * (1.0 - shot.vignetting * vignette_));
    cv::RNG rng(shot.seed * 7919U + 17U);
    cv::Mat noise(light.size(), CV_32F);
    rng.fill(noise, cv::RNG::NORMAL, 0.0, shot.noise);
    light += noise;
    const auto pixels = std::make_shared<Bytes>(static_cast<std::size_t>(light.total()));
    cv::Mat out(light.size(), CV_8U, pixels->data());
    light.convertTo(out, CV_8U);
    return {truth_.width, truth_.height, pixels};
  }

 private:
  static constexpr int across = 2;
  static constexpr int down = 2;

  cv::Mat look(const FlatFloor& floor, const Pose2& floor_from_robot, const agents::Attitude& attitude,
               const Shot& shot) const {
    Eigen::Matrix3d world_from_robot = Eigen::Matrix3d::Identity();
    const double c = std::cos(floor_from_robot.heading);
    const double s = std::sin(floor_from_robot.heading);
    world_from_robot << c, -s, floor_from_robot.x, s, c, floor_from_robot.y, 0, 0, 1;
    Eigen::Matrix3d texel_from_world = Eigen::Matrix3d::Identity() / FlatFloor::metres_per_texel;
    texel_from_world(0, 2) = texel_from_world(1, 2) = -0.5;
    texel_from_world(2, 2) = 1.0;
    const Eigen::Matrix3d texel_from_camera =
        texel_from_world * world_from_robot * agents::camera_from_plane(truth_, attitude, above_floor_m_).inverse();
    cv::Mat texels;
    cv::perspectiveTransform(rays_, texels, cv::Mat(agents::as_matx(texel_from_camera)));
    cv::Mat fine;
    cv::remap(floor.texture_, fine, texels, {}, cv::INTER_LINEAR, cv::BORDER_REFLECT_101);
    if (shot.shadow) darken(texels, fine);
    cv::Mat image;
    cv::resize(fine, image, {truth_.width, truth_.height}, 0, 0, cv::INTER_AREA);
    return image;
  }

  /// Darkens every second stripe: straight edges at 45 degrees, wherever x + y passes a multiple of 1.6 m.
  static void darken(const cv::Mat& texels, cv::Mat& fine) {
    for (int r = 0; r < fine.rows; ++r) {
      const auto* at = texels.ptr<cv::Vec2f>(r);
      auto* grey = fine.ptr<std::uint8_t>(r);
      for (int c = 0; c < fine.cols; ++c) {
        const double along = (at[c][0] + at[c][1]) * FlatFloor::metres_per_texel / 1.6;
        if (static_cast<std::int64_t>(std::floor(along)) % 2 != 0) grey[c] = static_cast<std::uint8_t>(0.4 * grey[c]);
      }
    }
  }

  agents::CameraModel truth_;
  double above_floor_m_;
  cv::Mat rays_;
  cv::Mat vignette_;
};

/// Returns a camera with 53 degrees to each side that looks up from 0.4 m above the floor, leaning ahead by its pitch
/// and to the right by its roll.
inline agents::CameraModel upward_camera(double pitch_rad = 0.0, double roll_rad = 0.0) {
  agents::CameraModel camera;
  camera.id = "up";
  camera.width = 640;
  camera.height = 480;
  camera.fx = camera.fy = 240.0;
  camera.cx = 319.5;
  camera.cy = 239.5;
  Eigen::Matrix3d upwards;
  upwards << 0, 1, 0, -1, 0, 0, 0, 0, 1;
  const Eigen::Quaterniond lean(Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitX()));
  camera.robot_from_camera = {lean * Eigen::Quaterniond(upwards), {0.12, -0.05, 0.4}};
  return camera;
}

/// Returns the paper's camera with a lens that distorts.
inline agents::CameraModel paper_camera(std::string id = "true") {
  agents::CameraModel camera;
  camera.id = std::move(id);
  camera.distortion = {-0.12, 0.03, 0.0005, -0.0004, 0.0};
  camera.robot_from_camera = agents::downward_mount(0.15, 0.0, 0.6, 0.735, 0.0, 0.0);
  return camera;
}

/// Returns a robot's calibration: off by 0.3 % of focal length, 3 mm and 0.3 degrees of mount (1 sigma each).
inline agents::CameraModel miscalibrated(const agents::CameraModel& truth, std::uint64_t seed, double amount = 1.0) {
  Random random(seed);
  const double deg = M_PI / 180.0;
  agents::CameraModel given = truth;
  given.id = "given-" + std::to_string(seed);
  const double focal = 1.0 + amount * 0.003 * random.normal();
  given.fx *= focal;
  given.fy *= focal;
  Vector6d error;
  for (int i = 0; i < 6; ++i) error(i) = amount * random.normal() * (i < 3 ? 0.003 : 0.3 * deg);
  given.robot_from_camera = truth.robot_from_camera * se3_exp(error);
  return given;
}

/// Simulates vibration: three sines between 5 and 20 Hz for each of pitch, roll and height.
class Vibration {
 public:
  Vibration(std::uint64_t seed, double tilt_rms_rad = 0.05 * M_PI / 180.0, double height_rms_m = 0.001)
      : rms_(tilt_rms_rad, tilt_rms_rad, height_rms_m) {
    Random random(seed);
    for (auto& axis : sines_)
      for (auto& sine : axis) sine = {random.uniform(5.0, 20.0), random.uniform(0.0, 2.0 * M_PI)};
  }
  agents::Attitude at(double t) const {
    Eigen::Vector3d v = Eigen::Vector3d::Zero();
    for (int axis = 0; axis < 3; ++axis)
      for (const auto& [hertz, phase] : sines_[static_cast<std::size_t>(axis)])
        v(axis) += rms_(axis) * std::sqrt(2.0 / 3.0) * std::sin(2.0 * M_PI * hertz * t + phase);
    return agents::Attitude::from(v);
  }

 private:
  Eigen::Vector3d rms_;
  std::array<std::array<std::pair<double, double>, 3>, 3> sines_{};
};

}  // namespace weft::test
