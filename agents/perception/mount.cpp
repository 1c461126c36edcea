#include "agents/perception/mount.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "agents/perception/lens.hpp"

namespace weft::agents {
namespace {

using MountError = Eigen::Vector3d;  // pitch, roll (rad), focal share
using Matrix23d = Eigen::Matrix<double, 2, 3>;
using Matrix93d = Eigen::Matrix<double, 9, 3>;
constexpr double kHuber = 1.5;

/// Computes the error, in pixels, of pairs of points for a mount that is wrong by `mount`.
class Errors {
 public:
  Errors(const CameraModel& camera, const MountError& mount, const PlanarState& state)
      : Errors(tilted(camera, mount.x(), mount.y()), 1.0 / (1.0 + mount.z()), focal_px(camera), state) {}
  Eigen::Vector2d operator()(const PlanePair& pair) const {
    return focal_px_ * (shorter_ * pair.in_b - reproject_(shorter_ * pair.in_a, pair.above_floor_m).in_b);
  }

 private:
  Errors(const CameraModel& turned, double shorter, double focal_px, const PlanarState& state)
      : reproject_(turned, turned, state), shorter_(shorter), focal_px_(focal_px) {}

  Reprojector reproject_;
  double shorter_;
  double focal_px_;
};

/// Computes the Jacobian of points' errors by pitch, roll and focal share, by central differences.
class ByMount {
 public:
  ByMount(const CameraModel& camera, const MountError& at, const PlanarState& state) {
    for (int i = 0; i < 3; ++i) {
      const MountError aside = kStep * MountError::Unit(i);
      more_.emplace_back(camera, at + aside, state);
      less_.emplace_back(camera, at - aside, state);
    }
  }
  Matrix23d operator()(const PlanePair& pair) const {
    Matrix23d jacobian;
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      jacobian.col(i) = (more_[k](pair) - less_[k](pair)) / (2.0 * kStep);
    }
    return jacobian;
  }

 private:
  static constexpr double kStep = 1e-5;
  std::vector<Errors> more_, less_;
};

AttitudePrior vibration_of(const MountPrior& prior) {
  const double tilt = 1.0 / (prior.vibration_tilt_rad * prior.vibration_tilt_rad);
  const double lift = 1.0 / (prior.vibration_height_m * prior.vibration_height_m);
  AttitudePrior out;
  out.information.diagonal() << tilt, tilt, lift, tilt, tilt, lift;
  return out;
}

}  // namespace

CameraModel tilted(const CameraModel& camera, double pitch_rad, double roll_rad) {
  CameraModel out = camera;
  const Eigen::Quaterniond turn =
      Eigen::AngleAxisd(pitch_rad, Eigen::Vector3d::UnitY()) * Eigen::AngleAxisd(roll_rad, Eigen::Vector3d::UnitX());
  out.robot_from_camera.rotation = (turn * camera.robot_from_camera.rotation).normalized();
  return out;
}

MountFilter::MountFilter(const CameraModel& camera, const MountPrior& prior) : camera_(camera), prior_(prior) {
  const double tilt = 1.0 / (prior.tilt_rad * prior.tilt_rad);
  information_ = Eigen::Vector3d(tilt, tilt, 0.0).asDiagonal();
}

MountTilt MountFilter::tilt() const {
  const Eigen::Matrix2d alone = information_.topLeftCorner<2, 2>().inverse();
  const Eigen::Vector2d mean = alone * weighted_;
  const Eigen::Vector2d by_focal = -prior_.focal_share * alone * information_.topRightCorner<2, 1>();
  return {mean.x(), mean.y(), alone + by_focal * by_focal.transpose(), alone};
}

void MountFilter::fade(double share) {
  information_ *= share;
  weighted_ *= share;
}

bool MountFilter::add(const PlaneViews& views) {
  constexpr double most_scale = 10.0;  // residuals so many times their sigma: another plane, or none
  const MountTilt believed = tilt();
  const MountError at(believed.pitch_rad, believed.roll_rad, 0.0);
  const CameraModel turned = tilted(camera_, at.x(), at.y());
  const std::vector<PlanePair>& points = views.points;
  const AttitudePrior vibration = vibration_of(prior_);
  const PlanarFit fit = fit_planar_motion(turned, turned, points, vibration, {views.a_from_b, {}, {}}, kHuber);
  if (!fit.converged || fit.scale > most_scale) return false;

  // Normal equations of the pair's own nine unknowns and the mount's three, at the pair's solution.
  Matrix9d own = Matrix9d::Zero();
  Vector9d own_pull = Vector9d::Zero();
  own.bottomRightCorner<6, 6>() = vibration.information;
  Vector6d attitude;
  attitude << fit.state.attitude_a.vector(), fit.state.attitude_b.vector();
  own_pull.tail<6>() = -vibration.information * attitude;
  Matrix93d mixed = Matrix93d::Zero();
  Eigen::Matrix3d mount = Eigen::Matrix3d::Zero();
  Eigen::Vector3d mount_pull = Eigen::Vector3d::Zero();
  const double f = focal_px(camera_);
  const Reprojector reproject_here(turned, turned, fit.state);
  const ByMount by_mount(camera_, at, fit.state);
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Reprojection there = reproject_here(points[k]);
    if (!there.in_front) continue;
    const double widened = std::max(1.0, fit.scale);
    Eigen::Vector2d error = points[k].in_sigmas(f * (points[k].in_b - there.in_b)) / widened;
    Eigen::Matrix2d in_sigmas = points[k].counts / (points[k].sigma_px * widened);
    if (points[k].above_floor_sigma_m > 0.0) {
      const Eigen::Matrix2d discount = points[k].discount(f * there.by_height);
      error = discount * error;
      in_sigmas = discount * in_sigmas;
    }
    const double off = error.norm();
    const double weight = off > kHuber ? kHuber / off : 1.0;
    const Matrix29d jo = f * in_sigmas * there.jacobian;
    const Matrix23d jm = -in_sigmas * by_mount(points[k]);  // of the prediction, as jo
    own.noalias() += weight * jo.transpose() * jo;
    own_pull.noalias() += weight * jo.transpose() * error;
    mixed.noalias() += weight * jo.transpose() * jm;
    mount.noalias() += weight * jm.transpose() * jm;
    mount_pull.noalias() += weight * jm.transpose() * error;
  }
  const Eigen::LDLT<Matrix9d> factors(own);
  const Eigen::Matrix3d told = mount - mixed.transpose() * factors.solve(mixed);
  const Eigen::Vector3d pull = mount_pull - mixed.transpose() * factors.solve(own_pull);
  if (!told.allFinite() || !pull.allFinite()) return false;
  information_ += 0.5 * (told + told.transpose());
  weighted_ += (told * at + pull).head<2>();
  ++pairs_;
  return true;
}

void MountWatch::add(const PlaneViews& views) {
  constexpr double kept = 1.0 - 1.0 / 150.0;  // pairs are 0.2 m long
  filter_.fade(kept);
  if (!filter_.add(views) || !views.wheels.has_value()) return;
  wheels_m_ = kept * wheels_m_ + views.wheels->translation().norm();
  seen_m_ = kept * seen_m_ + views.a_from_b.translation().norm();
}

std::optional<MountReport> MountWatch::report() const {
  constexpr std::size_t fewest = 10;
  constexpr double least_m = 1.0;
  if (filter_.pairs() < fewest) return std::nullopt;
  MountReport report{filter_.tilt(), filter_.pairs(), {}};
  if (seen_m_ >= least_m) report.height_by_wheels = wheels_m_ / seen_m_ - 1.0;
  return report;
}

std::optional<MountLever> lever_from(const std::vector<Pose2>& a_from_b, double yaw_before_rad,
                                     double forward_before_m) {
  constexpr std::size_t fewest = 5;
  if (a_from_b.size() < fewest) return std::nullopt;
  // With T = believed_from_true, a shift by (ahead, 0) and a turn, T^-1 M T has no lateral motion in the middle of
  // its arc: u_y = turn u_x - 2 sin(heading / 2) ahead, where u is M's translation from the arc's mean heading.
  std::vector<double> weight(a_from_b.size(), 1.0);
  Eigen::Vector2d found = Eigen::Vector2d::Zero();
  Eigen::Matrix2d information;
  double sigma = 1e-3;
  const Eigen::Vector2d before(1.0 / (yaw_before_rad * yaw_before_rad), 1.0 / (forward_before_m * forward_before_m));
  for (int pass = 0; pass < 10; ++pass) {
    information = before.asDiagonal();
    Eigen::Vector2d pull = Eigen::Vector2d::Zero();
    std::vector<double> errors;
    for (std::size_t i = 0; i < a_from_b.size(); ++i) {
      const double half = 0.5 * a_from_b[i].heading;
      const Eigen::Vector2d u = Eigen::Rotation2Dd(-half) * a_from_b[i].translation();
      const Eigen::Vector2d row(u.x(), -2.0 * std::sin(half));
      const double error = u.y() - row.dot(found);
      errors.push_back(std::abs(error));
      weight[i] = std::min(1.0, kHuber * sigma / std::max(std::abs(error), 1e-12)) / (sigma * sigma);
      information += weight[i] * row * row.transpose();
      pull += weight[i] * row * u.y();
    }
    found = information.ldlt().solve(pull);
    const auto middle = errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2);
    std::nth_element(errors.begin(), middle, errors.end());
    sigma = std::clamp(1.48 * *middle, 1e-5, 0.05);
  }
  const Eigen::Matrix2d covariance = information.inverse();
  return MountLever{-found.x(), -found.y(), std::sqrt(covariance(0, 0)), std::sqrt(covariance(1, 1))};
}

CameraModel shifted(const CameraModel& camera, const MountLever& lever) {
  CameraModel out = camera;
  const Eigen::Quaterniond turn(Eigen::AngleAxisd(lever.yaw_rad, Eigen::Vector3d::UnitZ()));
  out.robot_from_camera.rotation = (turn * camera.robot_from_camera.rotation).normalized();
  out.robot_from_camera.translation.x() += lever.forward_m;
  return out;
}

}  // namespace weft::agents
