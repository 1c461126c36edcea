#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "agents/bodies/sim/shades.hpp"
#include "agents/bodies/sim/site.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {

/// Describes the body that throws the shadow: an upright cylinder.
struct ShadowBody {
  double x = 0.0, y = 0.0;
  double radius_m = 0.28;
  double height_m = 0.5;
};

/// Lights the site by the lamps of one run (lamps_now); of the ambient light `Change::ambient` is left.
class Light {
 public:
  Light(const Site& site, double gloss_grey, Random random);

  /// Lights floor points (x, y) seen from `eye`: `gain` on the floor's albedo, 1 on average over the site, and
  /// `shine`, the grey levels that the mirrored lamps add. `shadow_share` 0: no shadow. All spans have one length.
  void on_floor(std::span<const float> x, std::span<const float> y, const Eigen::Vector3d& eye,
                const ShadowBody& body, double shadow_share, std::span<float> gain, std::span<float> shine) const;
  /// Lights upright faces at points (x, y, z), without shadow or shine.
  void on_wall(std::span<const float> x, std::span<const float> y, std::span<const float> z,
               std::span<float> gain) const;
  /// Sets the robot's place (far lamps are taken without shadow and shine), where moving shadows are by then, and how
  /// bright lamps are that flicker or have ended.
  void look_around(double x, double y, double time_s);

 private:
  void on_floor_part(const float* x, const float* y, std::size_t count, const Eigen::Vector3d& eye,
                     const ShadowBody& body, float shadow_share, float* gain, float* shine) const;
  struct LampNow {
    float x, y, height, brightness;
  };
  /// Holds points of a part of the floor, and how far the line from the eye goes on sideways a metre of height.
  struct Seen {
    std::span<const float> x, y, away_x, away_y;
    float eye_height_m = 1.0F;
  };
  void add_changes(const Seen& seen, std::span<float> gain, std::span<float> shine) const;
  void add_mirrored(const Seen& seen, float grey, float size_m, std::span<const float> share,
                    std::span<float> shine) const;

  std::vector<Lamp> as_written_;
  std::vector<LampNow> lamps_;  ///< of this run
  std::vector<LampNow> now_;    ///< of these, as bright as they are at the time
  std::vector<LampNow> near_;   ///< with shadow and shine
  std::vector<LampNow> far_;
  float ambient_ = 1.0F;
  float per_mean_ = 1.0F;
  float gloss_ = 0.0F;
  float glare_ = 0.0F, glare_size_m_ = 0.4F;
  float node_rad_ = 0.017F;  ///< between two nodes of the image's light grid
  float change_ = 1.0F;      ///< factor on all light
  Shades shades_;
};

}  // namespace weft::agents::sim
