#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "agents/perception/particles/particle_set.hpp"
#include "agents/perception/raster.hpp"
#include "agents/perception/scan.hpp"

namespace weft::agents {

struct LikelihoodConfig {
  double hit_share = 0.9;   ///< of beams that end where the map has something; (0, 1)
  double edge_share = 0.5;  ///< the same of floors that end: some end as their texture fades, before any wall; (0, 1)
  int beams = 60;           ///< of a scan that are used at most, evenly among those that returned; [1, 1000]
  double worth_beams = 20;  ///< independent beams that so many are worth, as neighbours err alike; (0, 1000]
  double most_m = 1.0;      ///< farther from anything does not tell more; (0, 10]
  /// Says what a beam that ends in an unknown cell counts as: between a stray one (0) and one that hits (1). [0, 1]
  double neutral = 0.5;
};

/// Describes an end of a beam, in the frame of the robot.
struct BeamEnd {
  float x = 0.0F;
  float y = 0.0F;
  std::size_t width = 0;  ///< index of kind and standard deviation among those of the field
};

/// Tells how likely beams end where they do, by how far that is from what is occupied (likelihood field: Thrun,
/// Burgard & Fox 2005, 6.4; sigma grows with the range). Read-only once made.
class LikelihoodField {
 public:
  /// Takes for each cell of the raster the distance to the nearest occupied one, metres, negative where nothing is
  /// known. Outside nothing is known.
  LikelihoodField(const LikelihoodConfig& config, const Raster& raster, std::span<const float> metres);

  const LikelihoodConfig& config() const { return config_; }
  /// Returns the ends of the beams that are used: at most `config.beams`, those without a return left out.
  std::vector<BeamEnd> ends_of(const Scan& scan) const;
  /// Returns whether the map knows anything of where a beam ends, seen from a pose.
  bool knows(const Pose2& map_from_robot, const BeamEnd& end) const;
  /// Doubles the standard deviations of all ends, up to the widest that the field has.
  static void widen(std::vector<BeamEnd>& ends);
  /// Adds up log-likelihoods of all ends for each particle: `logs` is as long as there are particles. Beams count as
  /// they are, not yet as what they are worth.
  void weigh(std::span<const BeamEnd> ends, const ParticleSet& particles, std::span<float> logs) const;
  /// Does the same one by one: what weigh() must equal bit by bit, whatever the processor can.
  void weigh_plain(std::span<const BeamEnd> ends, const ParticleSet& particles, std::span<float> logs) const;

 private:
  std::size_t width_of(const Beam& beam) const;

  LikelihoodConfig config_;
  Raster raster_;
  /// Holds distances as codes, with a rim of unknown cells around the raster and three bytes behind it.
  std::vector<std::uint8_t> codes_;
  std::vector<float> logs_;  ///< by kind, width and code
};

}  // namespace weft::agents
