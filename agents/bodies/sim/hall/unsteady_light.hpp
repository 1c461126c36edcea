#pragma once
#include <span>
#include <vector>

#include "agents/bodies/sim/hall/hall_light.hpp"

namespace weft::agents::sim {

/// Holds the light of a run on what stands still in a hall, and what of it comes from each lamp that flickers or
/// ends: shadows are worked out once, and the light of a time is told from that.
class UnsteadyLight {
 public:
  UnsteadyLight() = default;
  UnsteadyLight(const HallLight& light, std::span<const Quad> quads, const QuadScene* in_the_way);

  /// Returns whether no lamp ever changes.
  bool is_steady() const { return parts_.empty(); }
  /// Returns the light on each quad at a body's time, s.
  std::vector<QuadLight> at(double time_s) const;

 private:
  struct Part {
    Lamp lamp;
    std::vector<QuadLight> light;  ///< while it is as bright as it can be in this run
  };
  std::vector<QuadLight> all_;
  std::vector<Part> parts_;
};

}  // namespace weft::agents::sim
