#pragma once
#include <cstddef>
#include <string_view>
#include <tl/expected.hpp>

#include "agents/perception/clouds/ndt_cost.hpp"
#include "agents/perception/clouds/ndt_map.hpp"
#include "core/network/relation.hpp"

namespace weft::agents {

/// Configures the registration of two clouds. Set on simulated rooms (docs/results/clouds.md), none of it on
/// recordings.
struct NdtConfig {
  NdtCellConfig cells;
  NdtCostConfig cost;
  int most_steps = 12;             ///< of a level
  double inflation = 60.0;         ///< of the covariance that the means' own gives: errors of neighbours are alike
  double least_overlap = 0.2;      ///< share of b's finest cells that must lie near one of a's
  std::size_t least_matched = 20;  ///< cells
  double slides_m = 0.05;          ///< most sigma in any direction without a prior; turns count by their lever
  double prior_gate = 25.0;        ///< most squared Mahalanobis distance from the prior
};

/// Describes how two clouds lie to each other.
struct Registered {
  Metric3 a_from_b;
  std::size_t matched = 0;  ///< finest cells of b that lie near one of a
  double overlap = 0.0;     ///< their share of all of b's
  int from_prior = 0;       ///< directions, of 6, that stayed the prior's
};

/// Names why two clouds were not registered, with what was measured and its bound.
struct NotRegistered {
  std::string_view reason;  ///< few_cells, little_overlap, slides, disagrees_with_prior, diverged
  double measured = 0.0;
  double bound = 0.0;
};

using OrNotRegistered = tl::expected<Registered, NotRegistered>;

/// Registers two clouds given what is known before, of which the covariance is invertible: the pose that the cells
/// and the prior agree on best (MAP; Newton's method from the coarsest level to the finest). In directions in which
/// the cells know less than the prior, the prior's answer and covariance are kept whole: what overlap alone says
/// there is wrong (two views cut off at the same range pull each other together).
OrNotRegistered register_with_prior(const NdtMap& a, const NdtMap& b, const Metric3& prior, const NdtConfig& config);

/// Registers two clouds from a guess of which nothing is known. `slides`: in some direction they could be moved by
/// more than `slides_m` unnoticed, as along a plain aisle.
OrNotRegistered register_from_guess(const NdtMap& a, const NdtMap& b, const Pose3& guess, const NdtConfig& config);

}  // namespace weft::agents
