#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "agents/bodies/sim/change.hpp"

namespace weft::agents::sim {

/// Tells where cast shadows and wet areas lie on the floor at a time.
class Shades {
 public:
  explicit Shades(const Change& change);
  /// Lets only those near (x, y) count from then on, as they stand at that time.
  void look_around(double x, double y, double time_s);
  bool any_shadow() const { return !near_shadows_.empty(); }
  bool any_wet() const { return !near_wet_.empty(); }
  /// Holds floor points; rims are no sharper than `apart_m`, how far the next ones lie. All spans are of one length.
  struct Points {
    std::span<const float> x, y, apart_m;
  };
  /// Writes the share of the light that is left, [0, 1].
  void shadows(const Points& at, std::span<float> left) const;
  /// Writes 1 in the wet, 0 where it is dry, and between at rims.
  void wetness(const Points& at, std::span<float> wet) const;

 private:
  struct ShadowNow {
    float x, y, cos, sin, half_length, half_width, depth, soft;
  };
  struct WetNow {
    float x, y, radius, phase;
  };
  std::vector<CastShadow> all_shadows_;
  std::vector<WetArea> all_wet_;
  std::uint64_t seed_ = 0;
  std::vector<ShadowNow> near_shadows_;
  std::vector<WetNow> near_wet_;
};

}  // namespace weft::agents::sim
