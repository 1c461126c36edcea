#pragma once
#include <ceres/ceres.h>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "agents/adjustment/mosaic.hpp"

/// Holds what is minimised, in sigmas, as Ceres differentiates it. A pose is (x, y, heading), an attitude (pitch,
/// roll, height), a point (x, y, z).
namespace weft::agents {

inline constexpr double kHuberSigmas = 1.5;  ///< of sightings and told heights

/// Compares the ray to a point with the one on which it was seen, across that ray.
class SightingCost {
 public:
  SightingCost(const Pose3& robot_from_camera, const MosaicSighting& sighting)
      : camera_from_robot_(robot_from_camera.rotation.inverse().toRotationMatrix()),
        camera_in_robot_(robot_from_camera.translation) {
    across_.row(0) = sighting.ray.unitOrthogonal().transpose() / sighting.sigma_rad;
    across_.row(1) = sighting.ray.cross(sighting.ray.unitOrthogonal()).transpose() / sighting.sigma_rad;
  }

  static ceres::CostFunction* make(const Pose3& robot_from_camera, const MosaicSighting& sighting) {
    return new ceres::AutoDiffCostFunction<SightingCost, 2, 3, 3, 3>(new SightingCost(robot_from_camera, sighting));
  }

  template <class T>
  bool operator()(const T* map_from_place, const T* attitude, const T* point, T* residual) const {
    using std::cos;
    using std::sin;
    using Vector = Eigen::Matrix<T, 3, 1>;
    // level_from_body = T(0, 0, height) Ry(pitch) Rx(roll), undone from left to right.
    const T c = cos(map_from_place[2]), s = sin(map_from_place[2]);
    const T dx = point[0] - map_from_place[0], dy = point[1] - map_from_place[1];
    const Vector level(c * dx + s * dy, c * dy - s * dx, point[2] - attitude[2]);
    const T cp = cos(attitude[0]), sp = sin(attitude[0]), cr = cos(attitude[1]), sr = sin(attitude[1]);
    const Vector pitched(cp * level.x() - sp * level.z(), level.y(), sp * level.x() + cp * level.z());
    const Vector body(pitched.x(), cr * pitched.y() + sr * pitched.z(), cr * pitched.z() - sr * pitched.y());
    const Vector camera = camera_from_robot_.cast<T>() * (body - camera_in_robot_.cast<T>());
    Eigen::Map<Eigen::Matrix<T, 2, 1>> off(residual);
    off = across_.cast<T>() * camera.normalized();
    return true;
  }

 private:
  Eigen::Matrix3d camera_from_robot_;
  Eigen::Vector3d camera_in_robot_;
  Eigen::Matrix<double, 2, 3> across_;  ///< in sigmas
};

/// Holds a point at the height that was told of it. What is told is of the odometry's scale, and symmetric: a prior
/// by which points may hang below a ceiling but hardly lie above it shortens all ways, as noise puts half of them
/// above.
struct HeightCost {
  double told_m;
  double sigma_m;

  static ceres::CostFunction* make(const MosaicPoint& point) {
    return new ceres::AutoDiffCostFunction<HeightCost, 1, 3>(new HeightCost{point.told_m, point.told_sigma_m});
  }
  template <class T>
  bool operator()(const T* point, T* residual) const {
    residual[0] = (point[2] - told_m) / sigma_m;
    return true;
  }
};

/// Holds an attitude at what is known of it.
struct AttitudeCost {
  Eigen::Vector3d mean;
  Eigen::Vector3d sigma;

  static ceres::CostFunction* make(const MosaicPlace& place) {
    return new ceres::AutoDiffCostFunction<AttitudeCost, 3, 3>(
        new AttitudeCost{place.attitude.vector(), place.attitude_sigma});
  }
  template <class T>
  bool operator()(const T* attitude, T* residual) const {
    for (int i = 0; i < 3; ++i) residual[i] = (attitude[i] - mean[i]) / sigma[i];
    return true;
  }
};

/// Returns how far a pose lies from where it was expected from another one, in the frame of the expected one: to
/// first order the xi in a_from_b * se2_exp(xi).
template <class T>
Eigen::Matrix<T, 3, 1> off_from(const T* map_from_a, const T* map_from_b, const Pose2& a_from_b) {
  using std::atan2;
  using std::cos;
  using std::sin;
  const T heading = map_from_a[2] + a_from_b.heading;
  const T ca = cos(map_from_a[2]), sa = sin(map_from_a[2]);
  const T dx = map_from_b[0] - map_from_a[0] - (ca * a_from_b.x - sa * a_from_b.y);
  const T dy = map_from_b[1] - map_from_a[1] - (sa * a_from_b.x + ca * a_from_b.y);
  const T c = cos(heading), s = sin(heading);
  const T turned = map_from_b[2] - heading;
  return {c * dx + s * dy, c * dy - s * dx, atan2(sin(turned), cos(turned))};
}

/// Compares two poses with a link between them.
class LinkCost {
 public:
  explicit LinkCost(const MosaicLink& link)
      : from_from_to_(link.from_from_to), in_sigmas_(link.covariance.inverse().llt().matrixU()) {}

  static ceres::CostFunction* make(const MosaicLink& link) {
    return new ceres::AutoDiffCostFunction<LinkCost, 3, 3, 3>(new LinkCost(link));
  }
  template <class T>
  bool operator()(const T* map_from_a, const T* map_from_b, T* residual) const {
    Eigen::Map<Eigen::Matrix<T, 3, 1>> off(residual);
    off = in_sigmas_.cast<T>() * off_from(map_from_a, map_from_b, from_from_to_);
    return true;
  }

 private:
  Pose2 from_from_to_;
  Eigen::Matrix3d in_sigmas_;
};

}  // namespace weft::agents
