#include "agents/bodies/sim/light.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "agents/bodies/sim/floor/kernels.hpp"
#include "agents/bodies/sim/lamps.hpp"

namespace weft::agents::sim {
namespace {

constexpr float kMirrorBlurM = 0.9F;  // a lamp's own size and the floor's roughness, at the lamp
constexpr float kLampRadiusM = 0.25F;
constexpr double kNearM = 9.0;
constexpr float kWetDarkens = 0.35F;   // of what a soaked floor scatters
constexpr float kFilmGrey = 110.0F;    // in the middle of a lamp's mirror image in a film
constexpr float kFilmSizeM = 0.35F;    // of that image, at the lamp
constexpr float kFilmVeil = 5.0F;      // of the ceiling's mirror image under ambient light 1, grey levels
constexpr std::size_t kTogether = 64;  // points whose values stay in the nearest cache from lamp to lamp

/// Returns the light of a point lamp on a floor: the cosine to the fourth (two for distance, one for each surface).
float falloff(float dx, float dy, float height) {
  const float h2 = height * height;
  const float c2 = h2 / (dx * dx + dy * dy + h2);
  return c2 * c2;
}

constexpr float between(float x, float low, float high) {
  return x < low ? low : (x > high ? high : x);
}

/// Returns the factor by which a floor mirrors, more at grazing view: as Schlick 1994, but to the third power.
float fresnel(float away_x, float away_y) {
  const float cosine = 1.0F / std::sqrt(1.0F + away_x * away_x + away_y * away_y);
  const float grazing = (1.0F - cosine) * (1.0F - cosine) * (1.0F - cosine);
  return 0.5F + 2.5F * grazing;
}

/// Returns the share of a lamp that the body hides from (x, y): the part of the ray below its top against its axis.
/// Behind the ray's foot it hides only what it stands on. Without a branch: several points are worked out together.
float hidden_share(float x, float y, float lamp_x, float lamp_y, float lamp_h, const ShadowBody& body) {
  const float top = static_cast<float>(body.height_m) / lamp_h;
  const float dx = (lamp_x - x) * top;
  const float dy = (lamp_y - y) * top;
  const float bx = static_cast<float>(body.x) - x;
  const float by = static_cast<float>(body.y) - y;
  const float length2 = dx * dx + dy * dy;
  const float t = between((bx * dx + by * dy) / (length2 < 1e-9F ? 1e-9F : length2), 0.0F, 1.0F);
  const float u = bx - t * dx;
  const float v = by - t * dy;
  const float gap = std::sqrt(u * u + v * v) - static_cast<float>(body.radius_m);
  // Half shadow: the lamp's disc seen through the height at which the ray passes.
  const float above = 1.0F - t * top;
  const float soft = 0.02F + kLampRadiusM * t * top / (above < 0.05F ? 0.05F : above) * 2.0F;
  const float share = between(0.5F - gap / soft, 0.0F, 1.0F);
  return share * share * (3.0F - 2.0F * share);
}

}  // namespace

Light::Light(const Site& site, double gloss_grey, Random random)
    : as_written_(site.lamps),
      ambient_(static_cast<float>(site.ambient * site.change.ambient)),
      gloss_(static_cast<float>(site.change.light * gloss_grey)),
      glare_(static_cast<float>(site.change.light * site.change.glare_grey)),
      glare_size_m_(static_cast<float>(site.change.glare_size_m)),
      node_rad_(static_cast<float>(kShadeCell / site.camera.focal_px)),
      change_(static_cast<float>(site.change.light)),
      shades_(site.change) {
  const std::vector<double> bright = lamps_now(site, random);
  for (std::size_t i = 0; i < site.lamps.size(); ++i) {
    const Lamp& lamp = site.lamps[i];
    lamps_.push_back({static_cast<float>(lamp.x), static_cast<float>(lamp.y), static_cast<float>(lamp.height_m),
                      static_cast<float>(lamp.brightness * bright[i])});
  }
  far_ = now_ = lamps_;
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
  per_mean_ = static_cast<float>(site.change.light * count / std::max(1e-6, sum));
}

void Light::look_around(double x, double y, double time_s) {
  shades_.look_around(x, y, time_s);
  near_.clear();
  far_.clear();
  now_ = lamps_;
  for (std::size_t i = 0; i < now_.size(); ++i)
    now_[i].brightness *= static_cast<float>(share_at(as_written_[i], time_s));
  for (const LampNow& lamp : now_) {
    (std::hypot(lamp.x - x, lamp.y - y) < kNearM ? near_ : far_).push_back(lamp);
  }
}

void Light::on_floor(std::span<const float> x, std::span<const float> y, const Eigen::Vector3d& eye,
                     const ShadowBody& body, double shadow_share, std::span<float> gain,
                     std::span<float> shine) const {
  assert(x.size() == y.size() && x.size() == gain.size() && x.size() == shine.size());
  for (std::size_t from = 0; from < x.size(); from += kTogether) {
    const std::size_t count = std::min(kTogether, x.size() - from);
    on_floor_part(x.data() + from, y.data() + from, count, eye, body, static_cast<float>(shadow_share),
                  gain.data() + from, shine.data() + from);
  }
}

void Light::on_floor_part(const float* x, const float* y, std::size_t count, const Eigen::Vector3d& eye,
                          const ShadowBody& body, float shadow_share, float* gain, float* shine) const {
  std::array<float, kTogether> away_x{};
  std::array<float, kTogether> away_y{};
  std::array<float, kTogether> mirror{};
  std::array<float, kTogether> sum{};
  std::array<float, kTogether> mirrored{};
  for (std::size_t i = 0; i < count; ++i) {
    away_x[i] = static_cast<float>((static_cast<double>(x[i]) - eye.x()) / eye.z());
    away_y[i] = static_cast<float>((static_cast<double>(y[i]) - eye.y()) / eye.z());
    mirror[i] = gloss_ * fresnel(away_x[i], away_y[i]);
    sum[i] = ambient_;
  }
  for (const LampNow& lamp : near_) {
    for (std::size_t i = 0; i < count; ++i) {
      const float hidden = shadow_share * hidden_share(x[i], y[i], lamp.x, lamp.y, lamp.height, body);
      sum[i] += lamp.brightness * falloff(x[i] - lamp.x, y[i] - lamp.y, lamp.height) * (1.0F - hidden);
      const float u = (x[i] + away_x[i] * lamp.height - lamp.x) / kMirrorBlurM;
      const float v = (y[i] + away_y[i] * lamp.height - lamp.y) / kMirrorBlurM;
      const float lobe = 1.0F / (1.0F + u * u + v * v);
      mirrored[i] += lamp.brightness * mirror[i] * lobe * lobe;
    }
  }
  for (const LampNow& lamp : far_) {
    for (std::size_t i = 0; i < count; ++i) {
      sum[i] += lamp.brightness * falloff(x[i] - lamp.x, y[i] - lamp.y, lamp.height);
    }
  }
  for (std::size_t i = 0; i < count; ++i) {
    gain[i] = sum[i] * per_mean_;
    shine[i] = mirrored[i];
  }
  if (glare_ > 0.0F || shades_.any_shadow() || shades_.any_wet()) {
    const Seen seen{
        {x, count}, {y, count}, {away_x.data(), count}, {away_y.data(), count}, static_cast<float>(eye.z())};
    add_changes(seen, {gain, count}, {shine, count});
  }
}

void Light::add_changes(const Seen& seen, std::span<float> gain, std::span<float> shine) const {
  std::array<float, kTogether> share{};
  std::array<float, kTogether> apart_m{};
  for (std::size_t i = 0; i < gain.size(); ++i) {
    const float away2 = seen.away_x[i] * seen.away_x[i] + seen.away_y[i] * seen.away_y[i];
    apart_m[i] = node_rad_ * seen.eye_height_m * (1.0F + away2);
  }
  const Shades::Points at{seen.x, seen.y, std::span(apart_m).first(gain.size())};
  const std::span<float> shares = std::span(share).first(gain.size());
  if (glare_ > 0.0F) {
    std::fill(shares.begin(), shares.end(), 1.0F);
    add_mirrored(seen, glare_, glare_size_m_, shares, shine);
  }
  if (shades_.any_wet()) {
    shades_.wetness(at, shares);
    add_mirrored(seen, kFilmGrey * change_, kFilmSizeM, shares, shine);
    for (std::size_t i = 0; i < shares.size(); ++i) {
      gain[i] *= 1.0F - kWetDarkens * shares[i];
      shine[i] += kFilmVeil * change_ * ambient_ * shares[i];
    }
  }
  if (shades_.any_shadow()) {
    // What keeps a lamp's light from a point keeps its mirror image from there too.
    shades_.shadows(at, shares);
    for (std::size_t i = 0; i < shares.size(); ++i) {
      gain[i] *= shares[i];
      shine[i] *= shares[i];
    }
  }
}

/// Adds the lamps near by, mirrored by `share` of the floor with `grey` levels in the middle, as large as `size_m` at
/// the lamps.
void Light::add_mirrored(const Seen& seen, float grey, float size_m, std::span<const float> share,
                         std::span<float> shine) const {
  for (std::size_t i = 0; i < shine.size(); ++i) {
    const float ax = seen.away_x[i];
    const float ay = seen.away_y[i];
    const float mirror = grey * share[i] * fresnel(ax, ay);
    for (const LampNow& lamp : near_) {
      const float u = (seen.x[i] + ax * lamp.height - lamp.x) / size_m;
      const float v = (seen.y[i] + ay * lamp.height - lamp.y) / size_m;
      const float lobe = 1.0F / (1.0F + u * u + v * v);
      shine[i] += lamp.brightness * mirror * lobe * lobe;
    }
  }
}

void Light::on_wall(std::span<const float> x, std::span<const float> y, std::span<const float> z,
                    std::span<float> gain) const {
  assert(x.size() == y.size() && x.size() == z.size() && x.size() == gain.size());
  // Faces look sideways: the ambient light and the lamps at a slant.
  std::fill(gain.begin(), gain.end(), ambient_);
  const std::size_t count = gain.size();
  for (const LampNow& lamp : now_) {
    const float share = 0.7F * lamp.brightness;
    for (std::size_t i = 0; i < count; ++i) {
      const float height = lamp.height - z[i];
      gain[i] += share * falloff(x[i] - lamp.x, y[i] - lamp.y, height < 0.5F ? 0.5F : height);
    }
  }
  for (float& value : gain) value = static_cast<float>(0.8 * static_cast<double>(value * per_mean_));
}

}  // namespace weft::agents::sim
