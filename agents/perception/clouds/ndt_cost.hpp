#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "agents/perception/clouds/ndt_map.hpp"
#include "core/geometry/pose3.hpp"

namespace weft::agents {

/// Describes how much a pair of cells counts: -(weight / softness) exp(-softness / 2 d), with d their squared
/// Mahalanobis distance. Stoyanov et al. 2012 have softness d2 and d1 = weight / softness.
struct NdtCostConfig {
  double weight = 0.07;   ///< information of a pair, in that of independent measurements
  double softness = 0.6;  ///< of 3 sigma^2 pairs count exp(-softness / 2 * 3)
};

/// Holds the cost of a pose and its derivatives with respect to xi in a_from_b * se3_exp(xi), order (translation,
/// rotation).
struct NdtCost {
  double value = 0.0;
  Vector6d gradient = Vector6d::Zero();
  Matrix6d hessian = Matrix6d::Zero();      ///< exact; it may be indefinite
  Matrix6d information = Matrix6d::Zero();  ///< its part that is never indefinite (Gauss and Newton's)
  /// The same as both clouds say it: each pair counts in the direction of a's surface times that of b's. Along a wall
  /// its cells lean to and fro by noise, and each cloud alone seems to say how far along it is; two clouds lean
  /// differently. It may be indefinite.
  Matrix6d trusted = Matrix6d::Zero();
  Matrix6d scatter = Matrix6d::Zero();  ///< covariance of the gradient, from that of the cells' means
  std::size_t cells = 0;                ///< of b
  std::size_t matched = 0;              ///< of them, that lie near one of a

  NdtCost& operator+=(const NdtCost& other);
};

/// Names the cells of b that are matched.
enum class CellsOfB : std::uint8_t {
  all,
  finest  ///< those that no smaller cells hold the points of
};

/// Computes the cost of matching the cells of two clouds (D2D-NDT, Stoyanov et al. 2012, eqs. 7 to 15): over pairs of
/// a cell of b, moved to a, with those of a that surround it, which are taken as surfaces without an end. `is_last`:
/// also what only the last step needs, trusted and scatter.
NdtCost ndt_cost(const NdtLevel& a, const NdtLevel& b, const Pose3& a_from_b, const NdtCostConfig& config,
                 CellsOfB which, bool is_last);

}  // namespace weft::agents
