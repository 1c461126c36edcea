#include "agents/bodies/sim/light.hpp"

#include <algorithm>
#include <cmath>

namespace weft::agents::sim {
namespace {

constexpr float kMirrorBlurM = 0.9F;  // a lamp's own size and the floor's roughness, at the lamp
constexpr float kLampRadiusM = 0.25F;
constexpr double kNearM = 9.0;

/// Point lamp over a floor: the cosine to the fourth (two for distance, one for each surface).
float falloff(float dx, float dy, float height) {
  const float h2 = height * height;
  const float c2 = h2 / (dx * dx + dy * dy + h2);
  return c2 * c2;
}

/// Share of a lamp that the body hides from (x, y): the part of the ray below its top against its axis.
float hidden_share(float x, float y, float lamp_x, float lamp_y, float lamp_h, const ShadowBody& body) {
  const float top = static_cast<float>(body.height_m) / lamp_h;
  const float dx = (lamp_x - x) * top;
  const float dy = (lamp_y - y) * top;
  const float bx = static_cast<float>(body.x) - x;
  const float by = static_cast<float>(body.y) - y;
  const float toward = bx * dx + by * dy;
  const auto radius = static_cast<float>(body.radius_m);
  constexpr float least_soft = 0.02F;
  // Behind the ray's foot the body hides only what it stands on.
  if (toward <= 0.0F && bx * bx + by * by > (radius + least_soft) * (radius + least_soft)) return 0.0F;
  const float t = std::clamp(toward / std::max(1e-9F, dx * dx + dy * dy), 0.0F, 1.0F);
  const float u = bx - t * dx;
  const float v = by - t * dy;
  const float gap = std::sqrt(u * u + v * v) - radius;
  // Half shadow: the lamp's disc seen through the height at which the ray passes.
  const float soft = least_soft + kLampRadiusM * t * top / std::max(0.05F, 1.0F - t * top) * 2.0F;
  const float share = std::clamp(0.5F - gap / soft, 0.0F, 1.0F);
  return share * share * (3.0F - 2.0F * share);
}

}  // namespace

Light::Light(const Site& site, double gloss_grey, Random random)
    : ambient_(static_cast<float>(site.ambient)), gloss_(static_cast<float>(gloss_grey)) {
  for (const Lamp& lamp : site.lamps) {
    const double change = 1.0 + site.disturbances.light_change * random.uniform(-1.0, 1.0);
    lamps_.push_back({static_cast<float>(lamp.x), static_cast<float>(lamp.y), static_cast<float>(lamp.height_m),
                      static_cast<float>(lamp.brightness * change)});
  }
  far_ = lamps_;
  // The camera is set so that the floor comes out at its mean brightness with the lamps as the file has them.
  double sum = 0.0;
  int count = 0;
  for (double y = site.floor.y_min; y <= site.floor.y_max; y += 0.5) {
    for (double x = site.floor.x_min; x <= site.floor.x_max; x += 0.5) {
      double here = site.ambient;
      for (const Lamp& lamp : site.lamps) {
        here += lamp.brightness * falloff(static_cast<float>(x - lamp.x), static_cast<float>(y - lamp.y),
                                          static_cast<float>(lamp.height_m));
      }
      sum += here;
      ++count;
    }
  }
  per_mean_ = static_cast<float>(count / std::max(1e-6, sum));
}

void Light::look_around(double x, double y) {
  near_.clear();
  far_.clear();
  for (const LampNow& lamp : lamps_) {
    (std::hypot(lamp.x - x, lamp.y - y) < kNearM ? near_ : far_).push_back(lamp);
  }
}

Light::AtPoint Light::on_floor(double px, double py, double eye_x, double eye_y, double eye_z, const ShadowBody& body,
                               double shadow_share) const {
  const auto x = static_cast<float>(px);
  const auto y = static_cast<float>(py);
  const auto away_x = static_cast<float>((px - eye_x) / eye_z);
  const auto away_y = static_cast<float>((py - eye_y) / eye_z);
  // Schlick 1994: mirrors better at grazing view.
  const float cosine = 1.0F / std::sqrt(1.0F + away_x * away_x + away_y * away_y);
  const float grazing = (1.0F - cosine) * (1.0F - cosine) * (1.0F - cosine);
  const float mirror = gloss_ * (0.5F + 2.5F * grazing);
  float sum = ambient_;
  float shine = 0.0F;
  for (const LampNow& lamp : near_) {
    const float hidden =
        shadow_share > 0.0 ? static_cast<float>(shadow_share) * hidden_share(x, y, lamp.x, lamp.y, lamp.height, body)
                           : 0.0F;
    sum += lamp.brightness * falloff(x - lamp.x, y - lamp.y, lamp.height) * (1.0F - hidden);
    const float u = (x + away_x * lamp.height - lamp.x) / kMirrorBlurM;
    const float v = (y + away_y * lamp.height - lamp.y) / kMirrorBlurM;
    const float lobe = 1.0F / (1.0F + u * u + v * v);
    shine += lamp.brightness * mirror * lobe * lobe;
  }
  for (const LampNow& lamp : far_) {
    sum += lamp.brightness * falloff(x - lamp.x, y - lamp.y, lamp.height);
  }
  return {sum * per_mean_, shine};
}

double Light::on_wall(double x, double y, double z) const {
  // Faces look sideways: the ambient light and the lamps at a slant.
  float sum = ambient_;
  for (const LampNow& lamp : lamps_) {
    sum += 0.7F * lamp.brightness *
           falloff(static_cast<float>(x) - lamp.x, static_cast<float>(y) - lamp.y,
                   std::max(0.5F, lamp.height - static_cast<float>(z)));
  }
  return 0.8 * static_cast<double>(sum * per_mean_);
}

}  // namespace weft::agents::sim
