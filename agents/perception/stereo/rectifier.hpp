#pragma once
#include <memory>

#include "agents/perception/rig.hpp"
#include "agents/perception/stereo/stereo_rig.hpp"
#include "agents/perception/view.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Rectifies the pairs of one calibrated sensor: lenses are undone and both cameras turned so that what one sees on a
/// row the other sees on the same one (Fusiello, Trucco & Verri 2000). What goes where is worked out once.
class Rectifier {
 public:
  /// invalid: the sensor is no pair, its cameras' sizes differ, the right one is less than 5 mm to the right or looks
  /// more than 0.35 rad (20 degrees) elsewhere, or a camera breaks a bound of `check`; names the sensor, what and the
  /// bound.
  static Result<Rectifier> make(const Sensor& sensor);

  const StereoRig& rig() const { return rig_; }
  const CameraModel& left() const { return left_; }
  const CameraModel& right() const { return right_; }

  /// Returns whether pairs come rectified: `rectified` then gives them back as they are.
  bool is_rectified() const { return tables_ == nullptr; }
  /// Returns the pair as the rig sees it. Both images are whole and of the cameras' size (`fits`).
  StereoPair rectified(const StereoPair& pair) const;
  /// Returns whether both images are whole and of the cameras' size.
  bool fits(const StereoPair& pair) const;

  /// Return where a pixel of the left or right image as it was taken lies when rectified.
  Eigen::Vector2d rectified_left(const Eigen::Vector2d& pixel) const;
  Eigen::Vector2d rectified_right(const Eigen::Vector2d& pixel) const;
  /// Return where a rectified pixel lies in the left or right image as it was taken.
  Eigen::Vector2d taken_left(const Eigen::Vector2d& rectified) const;
  Eigen::Vector2d taken_right(const Eigen::Vector2d& rectified) const;

 private:
  struct Tables;

  CameraModel left_, right_;
  Eigen::Matrix3d rectified_from_left_ = Eigen::Matrix3d::Identity();
  Eigen::Matrix3d rectified_from_right_ = Eigen::Matrix3d::Identity();
  StereoRig rig_;
  std::shared_ptr<const Tables> tables_;  // null: nothing is to be done
};

}  // namespace weft::agents
