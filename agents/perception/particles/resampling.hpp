#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "agents/perception/particles/particle_set.hpp"
#include "core/random.hpp"

namespace weft::agents {

/// Bounds how many particles there are (KLD sampling: Fox 2001).
struct KldConfig {
  double epsilon = 0.05;     ///< of the Kullback-Leibler distance to the posterior; (0, 1]
  double z = 2.326;          ///< quantile of the normal distribution with which that holds: 99 %; (0, 5]
  double cell_m = 0.5;       ///< of the cells that are counted; (0, 5]
  double cell_rad = 0.1745;  ///< (0, pi]
  int least = 300;           ///< particles; [10, most]
  int most = 3000;           ///< [least, 1000000]
};

/// Returns how many particles `cells` occupied cells need (Fox 2001, eq. 8), within the bounds of the configuration.
std::size_t kld_count(const KldConfig& config, std::size_t cells);

/// Draws a pose of all those that a robot may have.
using DrawPose = std::function<Pose2(Random& random)>;

/// Returns how many particles the set needs, if a share of them is drawn from anywhere: draws them one by one until
/// there are as many as the cells that were met so far ask for (Fox 2001, table 1).
std::size_t count_needed(const KldConfig& config, const ParticleSet& particles, Random& random, double share = 0.0,
                         const DrawPose& anywhere = {});

/// Draws so many particles with a comb of equal spacing (low-variance sampling: Thrun, Burgard & Fox 2005,
/// table 4.4): one of weight w is drawn floor(n w) or ceil(n w) times, n w in the mean. Returns which, in order.
std::vector<std::size_t> draw_by_comb(const std::vector<double>& weights, std::size_t count, Random& random);

/// Returns the particles that were drawn, all of the same weight.
ParticleSet drawn_of(const ParticleSet& particles, const std::vector<std::size_t>& drawn);

/// Draws so many particles by a comb and returns them.
ParticleSet resample(const ParticleSet& particles, std::size_t count, Random& random);

/// Replaces each particle with probability `share` by a drawn pose of the same weight.
void inject(ParticleSet& particles, double share, const DrawPose& anywhere, Random& random);

}  // namespace weft::agents
