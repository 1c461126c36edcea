#include "agents/perception/planar_motion.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "agents/perception/lens.hpp"

namespace weft::agents {
namespace {

struct Normal {
  Matrix9d information = Matrix9d::Zero();
  Vector9d gradient = Vector9d::Zero();
};

void add_prior(const AttitudePrior& prior, const PlanarState& state, Normal& normal) {
  Vector6d attitude;
  attitude << state.attitude_a.vector(), state.attitude_b.vector();
  normal.information.bottomRightCorner<6, 6>() += prior.information;
  normal.gradient.tail<6>() += prior.information * (prior.mean - attitude);
}

PlanarState moved(const PlanarState& state, const Vector9d& step) {
  return {state.a_from_b * se2_exp(step.head<3>()), Attitude::from(state.attitude_a.vector() + step.segment<3>(3)),
          Attitude::from(state.attitude_b.vector() + step.tail<3>())};
}

double median(std::vector<double> values) {
  if (values.empty()) return 0.0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

Eigen::Matrix2d PlanePair::discount(const Eigen::Vector2d& px_per_m) const {
  const Eigen::Vector2d by_sigma = in_sigmas(above_floor_sigma_m * px_per_m);
  const double more = by_sigma.squaredNorm();
  if (!(more > 1e-12)) return Eigen::Matrix2d::Identity();
  // The inverse root of the covariance 1 + v v^T.
  return Eigen::Matrix2d::Identity() - (1.0 - 1.0 / std::sqrt(1.0 + more)) / more * by_sigma * by_sigma.transpose();
}

Reprojector::Tilt Reprojector::tilt_of(const Attitude& attitude) {
  const double cp = std::cos(attitude.pitch_rad);
  const double sp = std::sin(attitude.pitch_rad);
  const double cr = std::cos(attitude.roll_rad);
  const double sr = std::sin(attitude.roll_rad);
  Eigen::Matrix3d ry;
  Eigen::Matrix3d rx;
  Eigen::Matrix3d dry;
  Eigen::Matrix3d drx;
  ry << cp, 0, sp, 0, 1, 0, -sp, 0, cp;
  dry << -sp, 0, cp, 0, 0, 0, -cp, 0, -sp;
  rx << 1, 0, 0, 0, cr, -sr, 0, sr, cr;
  drx << 0, 0, 0, 0, -sr, -cr, 0, cr, -sr;
  return {ry * rx, dry * rx, ry * drx};
}

Reprojector::Viewpoint Reprojector::viewpoint_of(const CameraModel& camera, const Attitude& attitude) {
  return {camera.robot_from_camera.rotation.toRotationMatrix(), camera.robot_from_camera.translation,
          tilt_of(attitude), attitude.height_m};
}

/// Holds the point where a ray meets a plane, and its derivatives by the attitude and by the plane's height.
struct Reprojector::OnPlane {
  Eigen::Vector2d point;
  Eigen::Matrix<double, 2, 3> by_attitude;
  Eigen::Vector2d by_height;
  bool in_front;
};

Reprojector::OnPlane Reprojector::meet_plane(const Viewpoint& viewpoint, const Eigen::Vector2d& normalised,
                                             double above_floor_m) {
  const Eigen::Vector3d ray_in_body = viewpoint.body_from_camera * normalised.homogeneous();
  const Eigen::Vector3d ray = viewpoint.tilt.rotation * ray_in_body;
  const Eigen::Vector3d origin =
      viewpoint.tilt.rotation * viewpoint.position_in_body + Eigen::Vector3d(0.0, 0.0, viewpoint.height);
  const double up_m = above_floor_m - origin.z();
  const double depth = up_m / ray.z();
  OnPlane met{};
  met.in_front = (up_m < 0.0 && ray.z() < -1e-6) || (up_m > 0.0 && ray.z() > 1e-6);
  met.point = (origin + depth * ray).head<2>();
  const auto derivative = [&](const Eigen::Vector3d& d_origin, const Eigen::Vector3d& d_ray) -> Eigen::Vector2d {
    const double d_depth = -(d_origin.z() + depth * d_ray.z()) / ray.z();
    return (d_origin + depth * d_ray + d_depth * ray).head<2>();
  };
  met.by_attitude.col(0) =
      derivative(viewpoint.tilt.by_pitch * viewpoint.position_in_body, viewpoint.tilt.by_pitch * ray_in_body);
  met.by_attitude.col(1) =
      derivative(viewpoint.tilt.by_roll * viewpoint.position_in_body, viewpoint.tilt.by_roll * ray_in_body);
  met.by_attitude.col(2) = derivative(Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero());
  met.by_height = ray.head<2>() / ray.z();
  return met;
}

Reprojector::Reprojector(const CameraModel& a, const CameraModel& b, const PlanarState& state)
    : a_(viewpoint_of(a, state.attitude_a)),
      b_(viewpoint_of(b, state.attitude_b)),
      origin_(state.a_from_b.translation()) {
  const double c = std::cos(state.a_from_b.heading);
  const double s = std::sin(state.a_from_b.heading);
  b_from_a_ << c, s, -s, c;
}

Reprojection Reprojector::operator()(const Eigen::Vector2d& in_a, double above_floor_m) const {
  const Viewpoint& b = b_;
  const OnPlane met = meet_plane(a_, in_a, above_floor_m);
  const Eigen::Vector2d q = b_from_a_ * (met.point - origin_);
  const Eigen::Vector3d above(q.x(), q.y(), above_floor_m - b.height);
  const Eigen::Vector3d in_body = b.tilt.rotation.transpose() * above;
  const Eigen::Vector3d in_camera = b.body_from_camera.transpose() * (in_body - b.position_in_body);

  Reprojection out;
  out.in_front = met.in_front && in_camera.z() > 1e-6;
  out.in_b = in_camera.head<2>() / in_camera.z();
  Eigen::Matrix<double, 2, 3> projection;
  projection << 1.0, 0.0, -out.in_b.x(), 0.0, 1.0, -out.in_b.y();
  const Eigen::Matrix<double, 2, 3> by_body = projection / in_camera.z() * b.body_from_camera.transpose();
  const Eigen::Matrix<double, 2, 3> by_level = by_body * b.tilt.rotation.transpose();
  const Eigen::Matrix2d by_q = by_level.leftCols<2>();
  out.jacobian.col(0) = -by_q.col(0);
  out.jacobian.col(1) = -by_q.col(1);
  out.jacobian.col(2) = by_q * Eigen::Vector2d(q.y(), -q.x());
  out.jacobian.middleCols<3>(3) = by_q * b_from_a_ * met.by_attitude;
  out.jacobian.col(6) = by_body * b.tilt.by_pitch.transpose() * above;
  out.jacobian.col(7) = by_body * b.tilt.by_roll.transpose() * above;
  out.jacobian.col(8) = -by_level.col(2);
  out.by_height = by_q * (b_from_a_ * met.by_height) + by_level.col(2);
  return out;
}

Reprojection reproject(const CameraModel& a, const CameraModel& b, const PlanarState& state,
                       const Eigen::Vector2d& in_a, double above_floor_m) {
  return Reprojector(a, b, state)(in_a, above_floor_m);
}

PlanarFit fit_planar_motion(const CameraModel& a, const CameraModel& b, const std::vector<PlanePair>& pairs,
                            const AttitudePrior& prior, const PlanarState& start, double huber) {
  constexpr int most_iterations = 15;
  constexpr double settled = 3e-6;  // metres and radians: far below what views tell; Huber weights settle slowly
  constexpr double far_off_px = 1e3;
  const double f = focal_px(b);
  PlanarFit fit;
  fit.state = start;
  fit.residual_px.assign(pairs.size(), far_off_px);
  std::vector<double> whitened(pairs.size());
  Matrix9d information = Matrix9d::Identity();
  for (int i = 0; i < most_iterations; ++i) {
    const Reprojector reproject_here(a, b, fit.state);
    Normal normal;
    add_prior(prior, fit.state, normal);
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const Reprojection there = reproject_here(pairs[k]);
      const Eigen::Vector2d error = f * (pairs[k].in_b - there.in_b);
      fit.residual_px[k] = there.in_front ? std::min(error.norm(), far_off_px) : far_off_px;
      Eigen::Vector2d off = pairs[k].in_sigmas(error);
      whitened[k] = far_off_px / pairs[k].sigma_px;
      if (!(fit.residual_px[k] < far_off_px)) continue;
      Matrix29d jacobian = (f / pairs[k].sigma_px) * (pairs[k].counts * there.jacobian);
      if (pairs[k].above_floor_sigma_m > 0.0) {
        const Eigen::Matrix2d discount = pairs[k].discount(f * there.by_height);
        off = discount * off;
        jacobian = discount * jacobian;
      }
      whitened[k] = off.norm();
      const double weight = whitened[k] > huber ? huber / whitened[k] : 1.0;
      // Lazily: so small a product costs more to hand over than to multiply.
      normal.information += (weight * jacobian.transpose()).lazyProduct(jacobian);
      normal.gradient += (weight * jacobian.transpose()).lazyProduct(off);
    }
    information = normal.information;
    if (fit.converged) break;  // this pass was for the residuals and the information at the solution
    const Vector9d step = information.ldlt().solve(normal.gradient);
    if (!step.allFinite()) return fit;
    fit.state = moved(fit.state, step);
    fit.converged = step.cwiseAbs().maxCoeff() < settled;
  }
  // The median of a 2D normal error's length is 1.177 sigma.
  fit.scale = std::max(median(whitened) / 1.177, 0.05);
  fit.covariance = information.ldlt().solve(Matrix9d::Identity());
  fit.covariance.topLeftCorner<3, 3>() *= std::max(1.0, fit.scale * fit.scale);
  return fit;
}

}  // namespace weft::agents
