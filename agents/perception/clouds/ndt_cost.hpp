#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "agents/perception/clouds/ndt_map.hpp"
#include "core/geometry/pose3.hpp"

namespace weft::agents {

/// Describes how much a pair of cells counts: -(weight / softness) exp(-softness / 2 d), with d their squared
/// Mahalanobis distance. Stoyanov et al. 2012 have softness d2 and d1 = weight / softness.
struct NdtCostConfig {
  double weight = 0.03;   ///< information of a pair, in that of independent measurements
  double softness = 0.3;  ///< of 3 sigma^2 pairs count exp(-softness / 2 * 3)
};

/// Holds the cost of a pose and its derivatives with respect to xi in a_from_b * se3_exp(xi), order (translation,
/// rotation).
struct NdtCost {
  double value = 0.0;
  Vector6d gradient = Vector6d::Zero();
  Matrix6d hessian = Matrix6d::Zero();      ///< exact; it may be indefinite
  Matrix6d information = Matrix6d::Zero();  ///< its part that is never indefinite (Gauss and Newton's)
  /// The same without what the surfaces' uncertain tilts make of it: along a wall its cells lean to and fro by noise,
  /// and seem to say how far along they are. It may be indefinite.
  Matrix6d trusted = Matrix6d::Zero();
  Matrix6d scatter = Matrix6d::Zero();  ///< covariance of the gradient, from that of the cells' means
  std::size_t matched = 0;              ///< cells of b that lie near one of a
};

/// Computes the cost of matching the cells of two clouds (D2D-NDT, Stoyanov et al. 2012, eqs. 7 to 15): over pairs of
/// a cell of b, moved to a, with those of a that surround it. `with_scatter`: also that, which only the last step
/// needs.
NdtCost ndt_cost(const NdtLevel& a, const NdtLevel& b, const Pose3& a_from_b, const NdtCostConfig& config,
                 bool is_last);

}  // namespace weft::agents
