#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "agents/perception/stereo/stereo_rig.hpp"

namespace weft::agents {

/// Holds a point that a pair has seen at view a, and where the left camera sees it at view b.
struct SeenPoint {
  Eigen::Vector3d in_a = Eigen::Vector3d::Zero();  ///< the rig's camera frame
  double disparity_px = 1.0;                       ///< that it is made of
  Eigen::Vector2d at_b = Eigen::Vector2d::Zero();  ///< rectified pixel
  std::optional<double> disparity_at_b_px = {};    ///< none: b's right image was not looked at
};

struct PoseBounds {
  double within_px = 2.0;            ///< a point agrees that is off by less
  int hypotheses = 150;              ///< drawn at most
  double track_sigma_px = 0.2;       ///< of a pixel at b
  double disparity_sigma_px = 0.25;  ///< of a disparity
};

/// Holds where b is, as most points say.
struct PoseConsensus {
  Pose3 b_from_a;
  std::size_t count = 0;
};
/// Finds the pose that most points agree with: `expected`, or one of those that three of the points leave open (P3P,
/// Ke & Roumeliotis 2017). Draws from a fixed seed: equal points give equal answers.
PoseConsensus find_pose(const StereoRig& rig, const std::vector<SeenPoint>& points, const PoseBounds& bounds,
                        const Pose3& expected);

struct PoseFit {
  Pose3 b_from_a;
  Matrix6d covariance = Matrix6d::Zero();  ///< of xi in a_from_b * se3_exp(xi)
  std::vector<bool> is_inlier;
  std::size_t inliers = 0;
  double residual_px = 0.0;  ///< RMS of the inliers', less what the disparities' noise makes of it
};
/// Fits the pose to all points from `start` on by Gauss-Newton with Tukey's weights. A point counts by its pixel's
/// noise, by its disparity's at b where that is known, and by what its disparity's at a makes of it there: the
/// further b is from a, the more it moves along its ray. Points are fitted along their rays with the pose.
/// None: fewer than six count, or the points leave a direction open.
std::optional<PoseFit> fit_pose(const StereoRig& rig, const std::vector<SeenPoint>& points, const PoseBounds& bounds,
                                const Pose3& start);

}  // namespace weft::agents
