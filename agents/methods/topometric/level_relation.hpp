#pragma once
#include "agents/methods/topometric/config.hpp"
#include "agents/methods/topometric/content.hpp"
#include "core/network/relation.hpp"

namespace weft::agents {

/// Returns what is known before of two places as relations of level frames have it: x, y and heading as the guess
/// says, the rest by both floors. A guess is never taken for surer than 1 mm and 0.1 mrad.
Metric3 level_prior(const RelateConfig& config, const TopometricContent& a, const TopometricContent& b,
                    const Relation& a_from_b);

/// Returns the same where nothing is known but that both stand on a floor; `about` is where it is to be looked for.
Metric3 level_prior_about(const RelateConfig& config, const TopometricContent& a, const TopometricContent& b,
                          const Pose3& about);

/// Returns how far a relation is from what was known, in sigmas of x, y and heading together, once what `config`
/// grants a guess in any case is taken off.
double sigmas_from(const RelateConfig& config, const Metric3& known, const Pose3& a_from_b);

}  // namespace weft::agents
