#pragma once
#include <vector>

#include "agents/bodies/sim/site.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {

/// What throws the shadow: an upright cylinder.
struct ShadowBody {
  double x = 0.0, y = 0.0;
  double radius_m = 0.28;
  double height_m = 0.5;
};

/// The lamps of one run; each as bright as `random` makes it within the stated change.
class Light {
 public:
  Light(const Site& site, double gloss_grey, Random random);

  struct AtPoint {
    float gain = 1.0F;   ///< on the floor's albedo; 1 on average over the site
    float shine = 0.0F;  ///< grey levels that the mirrored lamps add
  };
  /// Floor point (x, y) seen from (eye_x, eye_y, eye_z). `shadow_share` 0: no shadow.
  AtPoint on_floor(double x, double y, double eye_x, double eye_y, double eye_z, const ShadowBody& body,
                   double shadow_share) const;
  /// On an upright face at a point, without shadow or shine.
  double on_wall(double x, double y, double z) const;
  /// Lamps further than this from the robot are taken without shadow and shine.
  void look_around(double x, double y);

 private:
  struct LampNow {
    float x, y, height, brightness;
  };
  std::vector<LampNow> lamps_;
  std::vector<LampNow> near_;  ///< with shadow and shine
  std::vector<LampNow> far_;
  float ambient_ = 1.0F;
  float per_mean_ = 1.0F;
  float gloss_ = 0.0F;
};

}  // namespace weft::agents::sim
