#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "agents/perception/camera_model.hpp"
#include "agents/perception/hamming.hpp"
#include "agents/perception/overlap.hpp"
#include "agents/perception/planar_motion.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::agents {

struct TwoCameras {
  const CameraModel& a;
  const CameraModel& b;
};

/// Describes a motion between two views and the pairs of points that agree with it.
struct RefinedMotion {
  PlanarFit fit;
  std::vector<PlanePair> pairs;     ///< inliers
  std::vector<double> residual_px;  ///< of the inliers
};

/// Fits the pairs that `start` names, takes every pair that the fit explains within `inlier_sigmas`, fits again: the
/// gate narrows from the consensus to the noise.
RefinedMotion refine_motion(const TwoCameras& cameras, const std::vector<PlanePair>& all,
                            const std::vector<std::size_t>& start, const AttitudePrior& prior,
                            const PlanarState& from, double inlier_sigmas);

/// Returns whether a point lies in a convex polygon.
bool contains(const Polygon& anticlockwise, const Eigen::Vector2d& point);

/// Returns how much of the plane that both see the agreeing features cover, [0, about 1]. Where a patch of a plane
/// looks like one elsewhere, they agree within that patch alone.
double spread_of_agreement(const std::vector<Match>& matches, const Pose2& a_from_b,
                           const std::vector<Eigen::Vector2d>& at_a, const std::vector<Eigen::Vector2d>& at_b,
                           const Polygon& seen_by_a, double within_m);

/// Returns the indices of a's features on the plane that b sees too.
std::vector<std::uint32_t> shared_stretch(const std::vector<Eigen::Vector2d>& at_a, const Polygon& seen_by_b,
                                          const Pose2& a_from_b);

}  // namespace weft::agents
