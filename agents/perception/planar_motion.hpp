#pragma once
#include <Eigen/Core>
#include <vector>

#include "agents/perception/attitude.hpp"
#include "agents/perception/camera_model.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::agents {

using Vector9d = Eigen::Matrix<double, 9, 1>;
using Matrix9d = Eigen::Matrix<double, 9, 9>;
using Matrix29d = Eigen::Matrix<double, 2, 9>;

/// Holds one point of a plane, or of what stands out from it, seen in two views; in undistorted normalised
/// coordinates.
struct PlanePair {
  Eigen::Vector2d in_a;
  Eigen::Vector2d in_b;
  double sigma_px = 1.0;  ///< of the difference between both, in pixels of b's view
  /// Weights a difference by its direction in the image, [0, 1]: along an edge a corner's place is hardly known.
  Eigen::Matrix2d counts = Eigen::Matrix2d::Identity();
  double above_floor_m = 0.0;        ///< of the point: 0 on a floor, a ceiling's height or less below a ceiling
  double above_floor_sigma_m = 0.0;  ///< 0: it is known

  /// Returns a difference given in pixels of b's view, weighted, in sigmas.
  Eigen::Vector2d in_sigmas(const Eigen::Vector2d& pixels) const { return counts * pixels / sigma_px; }
  /// Returns what a difference in sigmas has to be multiplied by, as the height is not known better: the less it
  /// counts, the more it lies along `px_per_m`, by which a metre of height moves the point in b's view.
  Eigen::Matrix2d discount(const Eigen::Vector2d& px_per_m) const;
};

/// Holds the state that two views determine: where b stands in the plane of a, and both attitudes.
struct PlanarState {
  Pose2 a_from_b;
  Attitude attitude_a;
  Attitude attitude_b;
};

/// Tells what is known of both attitudes before the points are looked at: mean and information of (attitude_a,
/// attitude_b), each (pitch, roll, height).
struct AttitudePrior {
  Vector6d mean = Vector6d::Zero();
  Matrix6d information = Matrix6d::Zero();
};

struct PlanarFit {
  PlanarState state;
  Matrix9d covariance =
      Matrix9d::Zero();  ///< of (xi in a_from_b * se2_exp(xi), attitude_a, attitude_b), scaled by the residuals
  std::vector<double> residual_px;  ///< |b - predicted b| of each pair
  double scale = 1.0;               ///< residuals over their stated sigma, robust; 1 when the sigmas are true
  bool converged = false;
};

/// Fits all six degrees of freedom, then projects: Gauss-Newton on reprojection errors in b with Huber weights
/// (threshold `huber` sigmas) and the prior, from `start`. Rigid planar motion alone turns a bump of 0.05 degrees
/// into 9 % of speed; the prior keeps what one pair of views cannot know (common tilt, height) where it was.
PlanarFit fit_planar_motion(const CameraModel& a, const CameraModel& b, const std::vector<PlanePair>& pairs,
                            const AttitudePrior& prior, const PlanarState& start, double huber = 1.5);

/// Holds the point that a sees at `in_a` as it appears in b, and its derivatives by (xi, attitude_a, attitude_b) and
/// by its height.
struct Reprojection {
  Eigen::Vector2d in_b;
  Matrix29d jacobian;
  Eigen::Vector2d by_height;  ///< of a metre
  bool in_front = false;
};
/// Reprojects many points in one state. A point lies where its ray in a meets the level plane at its height, which
/// may be below the camera or above it.
class Reprojector {
 public:
  Reprojector(const CameraModel& a, const CameraModel& b, const PlanarState& state);
  Reprojection operator()(const Eigen::Vector2d& in_a, double above_floor_m = 0.0) const;
  Reprojection operator()(const PlanePair& pair) const { return (*this)(pair.in_a, pair.above_floor_m); }

 private:
  /// Holds Ry(pitch) Rx(roll) and its derivatives.
  struct Tilt {
    Eigen::Matrix3d rotation;
    Eigen::Matrix3d by_pitch;
    Eigen::Matrix3d by_roll;
  };
  struct Viewpoint {
    Eigen::Matrix3d body_from_camera;
    Eigen::Vector3d position_in_body;
    Tilt tilt;
    double height;
  };
  struct OnPlane;
  static Tilt tilt_of(const Attitude& attitude);
  static Viewpoint viewpoint_of(const CameraModel& camera, const Attitude& attitude);
  static OnPlane meet_plane(const Viewpoint& viewpoint, const Eigen::Vector2d& normalised, double above_floor_m);

  Viewpoint a_;
  Viewpoint b_;
  Eigen::Matrix2d b_from_a_;  // turned alone
  Eigen::Vector2d origin_;    // of b in the plane of a
};
Reprojection reproject(const CameraModel& a, const CameraModel& b, const PlanarState& state,
                       const Eigen::Vector2d& in_a, double above_floor_m = 0.0);

}  // namespace weft::agents
