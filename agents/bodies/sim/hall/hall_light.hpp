#pragma once
#include <array>
#include <span>
#include <vector>

#include "agents/bodies/sim/hall/quad.hpp"
#include "agents/bodies/sim/hall/quad_scene.hpp"
#include "agents/bodies/sim/site.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {

/// Holds the light at the corners of a quad, (0, 0), (1, 0), (0, 1), (1, 1); 1 is the floor's mean with the lamps as
/// the site file has them.
struct QuadLight {
  std::array<float, 4> at{};
};

/// Lights a hall by the lamps of one run (lamps_now) and by its skylights, which are as bright as `Change::skylight`
/// says; of the ambient light `Change::ambient` is left. Things that stand in the way throw shadows.
class HallLight {
 public:
  HallLight(const Site& site, Random random);

  /// Returns the light on each quad. `in_the_way`: what throws shadows; null: nothing does.
  std::vector<QuadLight> on(std::span<const Quad> quads, const QuadScene* in_the_way) const;
  /// Returns what one lamp of the site gives of that, each quad.
  std::vector<QuadLight> by_lamp(std::size_t lamp, std::span<const Quad> quads, const QuadScene* in_the_way) const;
  /// Returns the same hall at a body's time, s: lamps that flicker or have ended are as bright as they are then.
  HallLight at_time(double time_s) const;
  /// Returns the lamps as the site file has them, in its order.
  const std::vector<Lamp>& lamps() const { return as_written_; }

 private:
  struct LampNow {
    Eigen::Vector3f at;
    float brightness;
    float shines;  ///< against the same lamp as the site file has it
  };
  float at(const Eigen::Vector3f& point, const Eigen::Vector3f& normal, const QuadScene* in_the_way) const;
  std::size_t lamp_at(const Quad& lamp) const;
  QuadLight of_lamp(const Quad& lamp) const;

  std::vector<Lamp> as_written_;
  std::vector<LampNow> lamps_;
  std::vector<LampNow> skylights_;
  float ambient_ = 1.0F;
  float per_mean_ = 1.0F;
  float change_ = 1.0F;
  float sky_ = 1.0F;  ///< of the skylights, against the site file
};

}  // namespace weft::agents::sim
