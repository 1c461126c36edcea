#include "agents/bodies/sim/shades.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

#include "core/random.hpp"

namespace weft::agents::sim {
namespace {

constexpr double kReachM = 6.0;      // the camera sees the floor no further
constexpr float kWetRimM = 0.03F;    // over which a film ends
constexpr double kMostUneven = 1.3;  // largest radius of a wet area against its mean

/// Returns the pose of the shadow's middle where its swing has brought it at that time.
Pose2 swung(const CastShadow& shadow, double time_s) {
  if (shadow.travel_m <= 0.0) return shadow.site_from_shadow;
  const double rate = 2.0 * shadow.speed_m_s / shadow.travel_m;  // its greatest speed is rate * travel / 2
  return shadow.site_from_shadow *
         Pose2{0.5 * shadow.travel_m * std::sin(rate * time_s + shadow.phase_rad), 0.0, 0.0};
}

float smooth(float share) {
  const float s = std::clamp(share, 0.0F, 1.0F);
  return s * s * (3.0F - 2.0F * s);
}

}  // namespace

Shades::Shades(const Change& change) : all_shadows_(change.shadows), all_wet_(change.wet), seed_(change.seed) {}

void Shades::look_around(double x, double y, double time_s) {
  near_shadows_.clear();
  for (const CastShadow& shadow : all_shadows_) {
    const Pose2 now = swung(shadow, time_s);
    const double reach = kReachM + 0.5 * std::hypot(shadow.length_m, shadow.width_m) + shadow.soft_m;
    if (std::hypot(now.x - x, now.y - y) > reach) continue;
    near_shadows_.push_back({static_cast<float>(now.x), static_cast<float>(now.y),
                             static_cast<float>(std::cos(now.heading)), static_cast<float>(std::sin(now.heading)),
                             static_cast<float>(shadow.length_m / 2), static_cast<float>(shadow.width_m / 2),
                             static_cast<float>(shadow.depth), static_cast<float>(shadow.soft_m)});
  }
  near_wet_.clear();
  for (std::size_t i = 0; i < all_wet_.size(); ++i) {
    const WetArea& wet = all_wet_[i];
    if (std::hypot(wet.x - x, wet.y - y) > kReachM + kMostUneven * wet.radius_m) continue;
    const double phase = Random(seed_).fork(i + 1).uniform(0.0, 2.0 * std::numbers::pi);
    near_wet_.push_back({static_cast<float>(wet.x), static_cast<float>(wet.y), static_cast<float>(wet.radius_m),
                         static_cast<float>(phase)});
  }
}

void Shades::shadows(const Points& at, std::span<float> left) const {
  assert(at.x.size() == left.size() && at.y.size() == left.size() && at.apart_m.size() == left.size());
  std::fill(left.begin(), left.end(), 1.0F);
  for (const ShadowNow& s : near_shadows_) {
    for (std::size_t i = 0; i < left.size(); ++i) {
      const float dx = at.x[i] - s.x;
      const float dy = at.y[i] - s.y;
      const float per_soft = 1.0F / std::max(s.soft, at.apart_m[i]);
      const float along = s.half_length - std::abs(s.cos * dx + s.sin * dy);
      const float across = s.half_width - std::abs(s.cos * dy - s.sin * dx);
      left[i] *= 1.0F - s.depth * smooth(0.5F + along * per_soft) * smooth(0.5F + across * per_soft);
    }
  }
}

void Shades::wetness(const Points& at, std::span<float> wet) const {
  assert(at.x.size() == wet.size() && at.y.size() == wet.size() && at.apart_m.size() == wet.size());
  std::fill(wet.begin(), wet.end(), 0.0F);
  for (const WetNow& w : near_wet_) {
    for (std::size_t i = 0; i < wet.size(); ++i) {
      const float dx = at.x[i] - w.x;
      const float dy = at.y[i] - w.y;
      const float soft = std::max(kWetRimM, at.apart_m[i]);
      const float distance = std::sqrt(dx * dx + dy * dy);
      if (distance > static_cast<float>(kMostUneven) * w.radius + soft) continue;
      const float angle = std::atan2(dy, dx);
      const float rim = w.radius * (1.0F + 0.16F * std::sin(3.0F * angle + w.phase) +
                                    0.1F * std::sin(5.0F * angle - 2.0F * w.phase));
      wet[i] = std::max(wet[i], smooth(0.5F + (rim - distance) / soft));
    }
  }
}

}  // namespace weft::agents::sim
