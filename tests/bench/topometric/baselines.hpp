#pragma once
#include <vector>

#include "agents/control/grid/clearance.hpp"
#include "agents/control/grid/ray_cast.hpp"
#include "agents/perception/particles/particle_set.hpp"
#include "agents/perception/scan.hpp"

/// Holds what our code is measured beside: the same done as it is usually written.
namespace weft::bench {

/// Makes a grid of clouds by a Bresenham line for each point, with the same rules of height and counts.
agents::OccupancyGrid bresenham_grid(const agents::Raster& raster, const agents::RayCastConfig& config,
                                     const std::vector<agents::SeenCloud>& clouds);

/// Weighs particles by a likelihood field as AMCL does: particle by particle, beam by beam, in doubles, with sine,
/// cosine and exponential each time, and the sum of cubes for a weight. Sets the weights, adding up to 1.
void amcl_weigh(const agents::DistanceMap& distances, const agents::Scan& scan, std::size_t beams, double sigma_m,
                agents::ParticleSet& particles);

}  // namespace weft::bench
