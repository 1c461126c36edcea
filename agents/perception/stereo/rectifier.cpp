#include "agents/perception/stereo/rectifier.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>
#include <utility>

#include "agents/perception/corner_tracks.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/opencv_view.hpp"

namespace weft::agents {

/// Says for each rectified pixel where its grey value is, as cv::remap has it: whole pixels, and parts of 32.
struct Rectifier::Tables {
  cv::Mat whole[2];
  cv::Mat parts[2];
};

namespace {

constexpr double kNarrowestM = 0.005;
constexpr double kMostTurnedRad = 0.35;

Result<void> check_pair(const Sensor& sensor) {
  const auto wrong = [&](const std::string& what) {
    return fail(ErrorCode::invalid, "stereo sensor \"" + sensor.id + "\": " + what);
  };
  if (sensor.kind != SensorKind::stereo || !sensor.right) return wrong("has no right camera; a pair is wanted");
  for (CameraModel camera : {sensor.camera, *sensor.right}) {
    camera.robot_from_camera.translation = {0.0, 0.0, 1.0};  // where the robot's frame is does not matter to a pair
    if (const Result<void> sound = check(camera); !sound) return wrong(sound.error().message);
  }
  if (sensor.camera.width != sensor.right->width || sensor.camera.height != sensor.right->height)
    return wrong("the left camera's images are " + std::to_string(sensor.camera.width) + "x" +
                 std::to_string(sensor.camera.height) + ", the right one's " + std::to_string(sensor.right->width) +
                 "x" + std::to_string(sensor.right->height) + "; they must be of one size");
  const Pose3 left_from_right = sensor.camera.robot_from_camera.inverse() * sensor.right->robot_from_camera;
  const Eigen::Vector3d& apart = left_from_right.translation;
  if (!(apart.x() >= kNarrowestM) || apart.x() < std::hypot(apart.y(), apart.z()))
    return wrong(
        "the right camera is at x = " + std::to_string(apart.x()) + ", y = " + std::to_string(apart.y()) +
        ", z = " + std::to_string(apart.z()) +
        " m of the left one's frame; x must be 0.005 m at least and more than y and z: are the two cameras in "
        "the right order?");
  const double turned = Eigen::AngleAxisd(left_from_right.rotation).angle();
  if (turned > kMostTurnedRad)
    return wrong("the right camera is turned by " + std::to_string(turned) +
                 " rad against the left one; at most 0.35 can be rectified");
  return {};
}

/// Returns the left camera's axes as they are when rectified, in the left camera's frame: x along the baseline, z
/// between both optical axes.
Eigen::Matrix3d left_from_rectified_of(const Pose3& left_from_right) {
  const Eigen::Vector3d x = left_from_right.translation.normalized();
  const Eigen::Vector3d ahead = Eigen::Vector3d::UnitZ() + left_from_right.rotation * Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d y = ahead.cross(x).normalized();
  Eigen::Matrix3d axes;
  axes.col(0) = x;
  axes.col(1) = y;
  axes.col(2) = x.cross(y);
  return axes;
}

Eigen::Vector2d turned(const Eigen::Matrix3d& b_from_a, const Eigen::Vector2d& in_a) {
  return (b_from_a * in_a.homogeneous()).hnormalized();
}

/// Bounds what a camera sees in rectified normalised coordinates: a rectangle within its image.
struct Seen {
  double left = -1e9, right = 1e9, top = -1e9, bottom = 1e9;

  void add(const CameraModel& camera, const Eigen::Matrix3d& rectified_from_camera) {
    constexpr int parts = 32;
    const double w = camera.width - 1.0;
    const double h = camera.height - 1.0;
    for (int i = 0; i <= parts; ++i) {
      const double share = static_cast<double>(i) / parts;
      const auto at = [&](double column, double row) {
        return turned(rectified_from_camera, normalised_from_pixel(camera, {column, row}));
      };
      left = std::max(left, at(0.0, share * h).x());
      right = std::min(right, at(w, share * h).x());
      top = std::max(top, at(share * w, 0.0).y());
      bottom = std::min(bottom, at(share * w, h).y());
    }
  }
};

/// Returns whether nothing is to be done but looking.
bool is_rectified_already(const CameraModel& left, const CameraModel& right, const Eigen::Matrix3d& turn) {
  constexpr double same_px = 0.01;
  constexpr double same_rad = 1e-5;
  const auto bends = [](const CameraModel& camera) {
    return camera.lens == LensModel::equidistant || camera.distortion != CameraModel().distortion ||
           camera.divisor != CameraModel().divisor;
  };
  const double off =
      std::max({std::abs(left.fx - left.fy), std::abs(left.fx - right.fx), std::abs(left.fy - right.fy),
                std::abs(left.cx - right.cx), std::abs(left.cy - right.cy)});
  const double turned_rad =
      Eigen::AngleAxisd(left.robot_from_camera.rotation.inverse() * right.robot_from_camera.rotation).angle();
  return !bends(left) && !bends(right) && off < same_px && turned_rad < same_rad &&
         (turn - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff() < same_rad;
}

StereoRig rig_within(const Seen& seen, const CameraModel& left) {
  StereoRig rig;
  rig.width = left.width;
  rig.height = left.height;
  rig.focal_px =
      std::max((left.width - 1.0) / (seen.right - seen.left), (left.height - 1.0) / (seen.bottom - seen.top));
  rig.cx = 0.5 * (left.width - 1.0) - 0.5 * rig.focal_px * (seen.left + seen.right);
  rig.cy = 0.5 * (left.height - 1.0) - 0.5 * rig.focal_px * (seen.top + seen.bottom);
  return rig;
}

}  // namespace

Result<Rectifier> Rectifier::make(const Sensor& sensor) {
  if (const Result<void> sound = check_pair(sensor); !sound) return fail(sound.error());
  Rectifier made;
  made.left_ = sensor.camera;
  made.right_ = *sensor.right;
  const Pose3 left_from_right = made.left_.robot_from_camera.inverse() * made.right_.robot_from_camera;
  const Eigen::Matrix3d left_from_rectified = left_from_rectified_of(left_from_right);
  made.rectified_from_left_ = left_from_rectified.transpose();
  made.rectified_from_right_ = made.rectified_from_left_ * left_from_right.rotation.toRotationMatrix();
  const bool is_done = is_rectified_already(made.left_, made.right_, left_from_rectified);
  if (is_done) {
    made.rectified_from_left_ = made.rectified_from_right_ = Eigen::Matrix3d::Identity();
    made.rig_ = {made.left_.width, made.left_.height, made.left_.fx, made.left_.cx, made.left_.cy, 0.0, {}};
    made.rig_.robot_from_camera = made.left_.robot_from_camera;
  } else {
    Seen seen;
    seen.add(made.left_, made.rectified_from_left_);
    seen.add(made.right_, made.rectified_from_right_);
    if (!(seen.right > seen.left) || !(seen.bottom > seen.top))
      return fail(ErrorCode::invalid, "stereo sensor \"" + sensor.id + "\": the two images overlap nowhere");
    made.rig_ = rig_within(seen, made.left_);
    made.rig_.robot_from_camera =
        made.left_.robot_from_camera * Pose3{Eigen::Quaterniond(left_from_rectified), Eigen::Vector3d::Zero()};
  }
  made.rig_.baseline_m = left_from_right.translation.norm();
  if (is_done) return made;
  const auto tables = std::make_shared<Tables>();
  for (int side = 0; side < 2; ++side) {
    cv::Mat map(made.rig_.height, made.rig_.width, CV_32FC2);
    for (int row = 0; row < map.rows; ++row)
      for (int column = 0; column < map.cols; ++column) {
        const Eigen::Vector2d rectified(column, row);
        const Eigen::Vector2d taken = side == 0 ? made.taken_left(rectified) : made.taken_right(rectified);
        map.at<cv::Vec2f>(row, column) = {static_cast<float>(taken.x()), static_cast<float>(taken.y())};
      }
    cv::convertMaps(map, cv::Mat(), tables->whole[side], tables->parts[side], CV_16SC2);
  }
  made.tables_ = tables;
  return made;
}

bool Rectifier::fits(const StereoPair& pair) const {
  const auto is_sound = [&](const Image& image) {
    return image.width == left_.width && image.height == left_.height && is_whole(image);
  };
  return is_sound(pair.left) && is_sound(pair.right);
}

StereoPair Rectifier::rectified(const StereoPair& pair) const {
  if (tables_ == nullptr) return pair;
  StereoPair out;
  for (int side = 0; side < 2; ++side) {
    const Image& from = side == 0 ? pair.left : pair.right;
    Bytes pixels(static_cast<std::size_t>(rig_.width) * static_cast<std::size_t>(rig_.height));
    cv::Mat to(rig_.height, rig_.width, CV_8UC1, pixels.data());
    cv::remap(as_mat(from), to, tables_->whole[side], tables_->parts[side], cv::INTER_LINEAR, cv::BORDER_REPLICATE);
    (side == 0 ? out.left : out.right) = {rig_.width, rig_.height, std::make_shared<const Bytes>(std::move(pixels))};
  }
  return out;
}

namespace {

Eigen::Vector2d rectified_pixel(const StereoRig& rig, const CameraModel& camera, const Eigen::Matrix3d& turn,
                                const Eigen::Vector2d& pixel) {
  const Eigen::Vector2d at = turned(turn, normalised_from_pixel(camera, pixel));
  return {rig.focal_px * at.x() + rig.cx, rig.focal_px * at.y() + rig.cy};
}

Eigen::Vector2d taken_pixel(const StereoRig& rig, const CameraModel& camera, const Eigen::Matrix3d& turn,
                            const Eigen::Vector2d& rectified) {
  const Eigen::Vector2d at((rectified.x() - rig.cx) / rig.focal_px, (rectified.y() - rig.cy) / rig.focal_px);
  return pixel_from_normalised(camera, turned(turn.transpose(), at));
}

}  // namespace

Eigen::Vector2d Rectifier::rectified_left(const Eigen::Vector2d& pixel) const {
  return rectified_pixel(rig_, left_, rectified_from_left_, pixel);
}

Eigen::Vector2d Rectifier::rectified_right(const Eigen::Vector2d& pixel) const {
  return rectified_pixel(rig_, right_, rectified_from_right_, pixel);
}

Eigen::Vector2d Rectifier::taken_left(const Eigen::Vector2d& rectified) const {
  return taken_pixel(rig_, left_, rectified_from_left_, rectified);
}

Eigen::Vector2d Rectifier::taken_right(const Eigen::Vector2d& rectified) const {
  return taken_pixel(rig_, right_, rectified_from_right_, rectified);
}

}  // namespace weft::agents
