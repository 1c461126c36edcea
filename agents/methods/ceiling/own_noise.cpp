#include "agents/methods/ceiling/own_noise.hpp"

namespace weft::agents {

PlanarFit fit_with_own_noise(const CameraModel& camera, std::vector<PlanePair>& pairs, double stated_px,
                             const AttitudePrior& prior, const PlanarState& start) {
  constexpr int rounds = 3;
  constexpr double enough = 1.2;  // a sigma that is right to so much is right
  PlanarFit fit = fit_planar_motion(camera, camera, pairs, prior, start);
  for (int round = 0; round < rounds && fit.scale > enough; ++round) {
    const double wider = fit.scale;
    for (PlanePair& pair : pairs) pair.sigma_px *= wider;
    fit = fit_planar_motion(camera, camera, pairs, prior, fit.state);
  }
  if (!pairs.empty()) fit.scale *= pairs.front().sigma_px / stated_px;
  return fit;
}

}  // namespace weft::agents
