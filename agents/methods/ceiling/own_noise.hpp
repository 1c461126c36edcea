#pragma once
#include <vector>

#include "agents/perception/planar_motion.hpp"

namespace weft::agents {

/// Returns the motion as fit_planar_motion has it, with the tracks' noise as what the fit leaves shows it where that
/// is more than stated; writes that noise into the pairs. Huber's bound and the prior of both attitudes are in
/// sigmas: of corners that err by ten of them nearly all are cut, and together they outweigh the prior by a hundred,
/// so that attitudes follow noise and the fit hardly settles (Huber 1981, chapter 7: location and scale at once). The
/// fit's scale is over the noise that was stated at first, `stated_px`.
PlanarFit fit_with_own_noise(const CameraModel& camera, std::vector<PlanePair>& pairs, double stated_px,
                             const AttitudePrior& prior, const PlanarState& start);

}  // namespace weft::agents
