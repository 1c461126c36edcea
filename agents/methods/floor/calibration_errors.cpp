#include "agents/methods/floor/calibration_errors.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <vector>

#include "agents/perception/camera_error.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/plane/geometry.hpp"

namespace weft::agents {
namespace {

constexpr int kQuantities = 8;  // focal length, optical centre (2), lens, height, place ahead and aside, heading
using Vector9 = Eigen::Matrix<double, 9, 1>;
using BySigma = Eigen::Matrix<double, 9, kQuantities>;

/// Returns a point of the floor in the robot's frame from the ray that sees it.
Eigen::Vector2d on_floor(const CameraModel& camera, const Eigen::Vector2d& normalised) {
  return apply(camera_from_floor(camera, Attitude{}).inverse(), normalised);
}

/// Returns what a camera that is truly `real` shows of the floor before and after a motion, as the calibration
/// `given` makes it out: pixels on a grid.
std::vector<PlanePair> pairs_of(const CameraModel& given, const CameraModel& real, const Pose2& a_from_b,
                                const FloorConfig& config) {
  constexpr int kColumns = 12;
  constexpr int kRows = 8;
  std::vector<PlanePair> pairs;
  const Eigen::Vector2d eye = real.robot_from_camera.translation.head<2>();
  const Eigen::Matrix3d camera_here = camera_from_floor(real, Attitude{});
  for (int column = 0; column < kColumns; ++column) {
    for (int row = 0; row < kRows; ++row) {
      const Eigen::Vector2d in_a((column + 0.5) / kColumns * given.width, (row + 0.5) / kRows * given.height);
      const Eigen::Vector2d seen_by_a = normalised_from_pixel(real, in_a);
      const Eigen::Vector2d floor_a = on_floor(real, seen_by_a);
      const Eigen::Vector3d ray = real.robot_from_camera.rotation * seen_by_a.homogeneous();
      if (ray.z() >= 0.0 || (floor_a - eye).norm() > 2.0 * config.far_m) continue;  // above the horizon, or far
      const Eigen::Vector2d floor_b = a_from_b.inverse() * floor_a;
      const Eigen::Vector3d there = camera_here * floor_b.homogeneous();
      if (there.z() <= 0.0) continue;
      const Eigen::Vector2d in_b = pixel_from_normalised(real, there.hnormalized());
      if (in_b.x() < 0.0 || in_b.y() < 0.0 || in_b.x() > given.width - 1.0 || in_b.y() > given.height - 1.0) continue;
      pairs.push_back(
          {normalised_from_pixel(given, in_a), normalised_from_pixel(given, in_b), config.track_sigma_px});
    }
  }
  return pairs;
}

/// Returns the tilt that the mount's filter finds for a camera that is off, whatever it was before: of the
/// calibration or of the drive. Straights and bends.
MountTilt tilt_found(const FloorConfig& config, const CameraModel& given, const CameraModel& real) {
  MountPrior prior;
  prior.vibration_tilt_rad = config.vibration_tilt_rad;
  prior.vibration_height_m = config.vibration_height_m;
  MountFilter filter(given, prior);
  for (int pass = 0; pass < 3; ++pass) {
    for (const double turned : {0.0, config.keyframe_rad, -config.keyframe_rad}) {
      const Pose2 motion = se2_exp(Eigen::Vector3d(config.keyframe_m, 0.0, turned));
      filter.add({pairs_of(given, real, motion, config), motion, std::nullopt});
    }
  }
  return filter.tilt();
}

/// Returns the error of one fit, x, y and heading. Each view's own tilt and height may differ from the mount's by
/// vibration, and take up a part of what is wrong.
Eigen::Vector3d error_of_fit(const FloorConfig& config, const CameraModel& given, const CameraModel& real,
                             const MountTilt& tilt, const Eigen::Vector3d& moved) {
  const double tilted2 = config.vibration_tilt_rad * config.vibration_tilt_rad;
  const double lifted2 = config.vibration_height_m * config.vibration_height_m;
  AttitudePrior prior;
  prior.mean << tilt.pitch_rad, tilt.roll_rad, 0.0, tilt.pitch_rad, tilt.roll_rad, 0.0;
  prior.information.diagonal() << 1.0 / tilted2, 1.0 / tilted2, 1.0 / lifted2, 1.0 / tilted2, 1.0 / tilted2,
      1.0 / lifted2;
  const Pose2 motion = se2_exp(moved);
  const PlanarState start{motion, Attitude::from(prior.mean.head<3>()), Attitude::from(prior.mean.tail<3>())};
  const PlanarFit fit = fit_planar_motion(given, given, pairs_of(given, real, motion, config), prior, start);
  return se2_log(motion.inverse() * fit.state.a_from_b);
}

/// Returns how odometry errs from keyframe to keyframe: of a metre ahead, of a metre aside, of a radian as robots
/// turn, in a bend of 1 m.
Vector9 errors_of_steps(const FloorConfig& config, const CameraModel& given, const CameraModel& real,
                        const MountTilt& tilt) {
  constexpr double kBendM = 1.0;
  const auto error = [&](double ahead, double aside, double turned) {
    return error_of_fit(config, given, real, tilt, {ahead, aside, turned});
  };
  const double way = config.keyframe_m;
  const double turn = std::min(config.keyframe_rad, config.keyframe_m / kBendM);
  Vector9 errors;
  errors << error(way, 0.0, 0.0) / way, error(0.0, way, 0.0) / way,
      (error(kBendM * turn, 0.0, turn) - error(kBendM * turn, 0.0, -turn)) / (2.0 * turn);
  return errors;
}

std::array<CameraError, kQuantities> sigmas_of(const FloorConfig& config) {
  std::array<CameraError, kQuantities> sigmas{};
  sigmas[0].focal_share = config.focal_share;
  sigmas[1].centre_px.x() = config.centre_px;
  sigmas[2].centre_px.y() = config.centre_px;
  sigmas[3].distortion_px = config.distortion_px;
  sigmas[4].shift_m.z() = config.mount_height_m;
  sigmas[5].shift_m.x() = config.mount_position_m;
  sigmas[6].shift_m.y() = config.mount_position_m;
  sigmas[7].turn_rad.z() = config.mount_yaw_rad;
  return sigmas;
}

/// Changes what is known of the quantities so that one of the errors that they make, of which a drive has told, has
/// the sigma that it was measured with. 0: it was not.
void measure(const BySigma& by_sigma, int error, double sigma,
             Eigen::Matrix<double, kQuantities, kQuantities>& known) {
  if (sigma <= 0.0) return;
  const Eigen::Matrix<double, kQuantities, 1> by = by_sigma.row(error).transpose();
  const double before = by.dot(known * by);
  if (before <= 0.0) return;
  const Eigen::Matrix<double, kQuantities, 1> shared = known * by;
  known += (sigma * sigma / before - 1.0) / before * shared * shared.transpose();
}

}  // namespace

CalibrationErrors::CalibrationErrors(const FloorConfig& config, const CameraModel& camera) {
  BySigma by_sigma;
  const std::array<CameraError, kQuantities> sigmas = sigmas_of(config);
  for (int i = 0; i < kQuantities; ++i) {
    const CameraModel real = with_error(camera, sigmas.at(static_cast<std::size_t>(i)));
    by_sigma.col(i) = errors_of_steps(config, camera, real, tilt_found(config, camera, real));
  }
  Eigen::Matrix<double, kQuantities, kQuantities> known;
  known.setIdentity();
  constexpr int kScaleAhead = 0;
  constexpr int kAsideAhead = 1;
  measure(by_sigma, kScaleAhead, config.measured_scale, known);
  measure(by_sigma, kAsideAhead, config.measured_heading_rad, known);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, kMotions, kMotions>> parts(by_sigma * known *
                                                                                       by_sigma.transpose());
  by_calibration_ = parts.eigenvectors() * parts.eigenvalues().cwiseMax(0.0).cwiseSqrt().asDiagonal();

  constexpr double kTilt = 0.001;  // rad
  for (int i = 0; i < 2; ++i) {
    const CameraModel real = i == 0 ? tilted(camera, kTilt, 0.0) : tilted(camera, 0.0, kTilt);
    by_tilt_.col(i) = errors_of_steps(config, camera, real, MountTilt{}) / kTilt;
  }
}

PlanarErrors CalibrationErrors::of(const Pose2& moved, const Eigen::Matrix2d& tilt_covariance) const {
  const Eigen::Vector3d xi = se2_log(moved);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> tilt(tilt_covariance);
  const Eigen::Matrix<double, kMotions, 2> by_tilt = by_tilt_ * tilt.operatorSqrt();
  PlanarErrors errors;
  errors.leftCols<kMotions>().setZero();
  errors.rightCols<2>().setZero();
  for (int axis = 0; axis < 3; ++axis) {
    errors.leftCols<kMotions>() += xi[axis] * by_calibration_.middleRows<3>(3 * axis);
    errors.rightCols<2>() += xi[axis] * by_tilt.middleRows<3>(3 * axis);
  }
  return errors;
}

}  // namespace weft::agents
