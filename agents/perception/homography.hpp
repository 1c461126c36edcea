#pragma once
#include <Eigen/Core>
#include <optional>
#include <string_view>
#include <vector>

#include "agents/perception/attitude.hpp"

namespace weft::agents {

/// Holds a homography b_from_a in normalised coordinates, as all here are: robots have different cameras.
struct RobustHomography {
  Eigen::Matrix3d b_from_a = Eigen::Matrix3d::Identity();
  std::vector<bool> inlier;  ///< of each pair
  std::size_t inliers = 0;
};

/// Fits the homography of Gadd & Newman, eq. 1, robustly (OpenCV's USAC with PROSAC sampling: the best pairs come
/// first). None when fewer than 8 pairs are given or no model is found. `threshold` in normalised units.
std::optional<RobustHomography> robust_homography(const std::vector<Eigen::Vector2d>& in_a,
                                                  const std::vector<Eigen::Vector2d>& in_b, double threshold);

/// Describes b_from_a = R + t n^T / d (Gadd & Newman, eq. 2): n is the plane's normal in a, pointing away from a.
struct PlaneMotion {
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  Eigen::Vector3d translation_in_heights = Eigen::Vector3d::Zero();  ///< t / d
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
};

/// Returns the motions, up to four, that one homography allows; the plane lies in front of camera a in each.
std::vector<PlaneMotion> decompose(const Eigen::Matrix3d& b_from_a);

/// Bounds the motions that are believed, as the paper's tests intend: its printed bound on n . z cannot hold for a
/// pitched camera, so the angle to the normal that the mount expects is bounded, before the motion and after it.
struct DecompositionBounds {
  double normal_angle_rad = 0.35;        ///< alpha_R: n against the mount's normal, and R n likewise
  double along_normal_in_heights = 0.1;  ///< alpha_t: |n . t| / d, how far a robot may leave the floor
};

struct Decomposed {
  std::optional<PlaneMotion> motion;
  double normal_angle_rad = 0.0;  ///< of the best candidate, whether it passed or not
};
/// Chooses, of the candidates that pass, the one whose normal is nearest to the expected one; none when all fail.
Decomposed choose(const std::vector<PlaneMotion>& candidates, const Eigen::Vector3d& expected_normal,
                  const DecompositionBounds& bounds);

/// Returns 2 eta^2 (sqrt(1 + e^2 / eta^2) - 1), e a reprojection error in pixels: Gadd & Newman, eq. 4, corrected.
double huber_distance(double error_px, double eta_px);

/// Returns h_distance without matches: the mean `huber_distance` of how far, in pixels, the homography moves the four
/// corners and the centre of the image of camera `a` from where they are.
double huber_distance(const Eigen::Matrix3d& b_from_a, const CameraModel& a, double eta_px);

}  // namespace weft::agents
