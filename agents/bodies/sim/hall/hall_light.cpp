#include "agents/bodies/sim/hall/hall_light.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "agents/bodies/sim/lamps.hpp"

namespace weft::agents::sim {
namespace {

constexpr float kLampGrey = 12.0F;     // of a lamp's own face against a lit floor under it
constexpr float kDarkLampGrey = 0.3F;  // likewise, of one that gives no light

/// Returns the light that a lamp at `lamp` that shines down gives a surface, 1 on the floor below it.
float falloff(const Eigen::Vector3f& lamp, const Eigen::Vector3f& point, const Eigen::Vector3f& normal) {
  constexpr float sideways = 0.15F;  // of its light that a lamp gives to what is beside or above it
  const Eigen::Vector3f way = lamp - point;
  const float distance2 = std::max(0.04F, way.squaredNorm());
  const float distance = std::sqrt(distance2);
  const float facing = std::max(0.0F, normal.dot(way)) / distance;
  const float down = std::max(sideways, way.z() / distance);
  return lamp.z() * lamp.z() * facing * down / distance2;
}

/// Returns light of a lamp there, or 0 where something is in the way, or where it is too little to count.
float arriving(float light, const Eigen::Vector3f& lamp, const Eigen::Vector3f& from, const QuadScene* in_the_way) {
  if (light < 0.003F) return 0.0F;
  const Eigen::Vector3f under = lamp - 0.1F * Eigen::Vector3f::UnitZ();
  return in_the_way == nullptr || !in_the_way->is_hidden(from, under) ? light : 0.0F;
}

/// Returns a point above the surface itself.
Eigen::Vector3f above(const Eigen::Vector3f& point, const Eigen::Vector3f& normal) {
  constexpr float above_m = 0.02F;
  return point + above_m * normal;
}

/// Returns a corner of a quad, a little within: one that touches its neighbour would lie in its shadow.
Eigen::Vector3f corner_of(const Quad& quad, std::size_t corner) {
  constexpr float inset = 0.04F;
  const float u = corner % 2 == 0 ? inset : 1.0F - inset;
  const float v = corner < 2 ? inset : 1.0F - inset;
  return quad.at(u, v);
}

}  // namespace

HallLight::HallLight(const Site& site, Random random)
    : as_written_(site.lamps), ambient_(static_cast<float>(site.ambient)) {
  const std::vector<double> bright = lamps_now(site, random);
  std::vector<LampNow> as_written;
  for (std::size_t i = 0; i < site.lamps.size(); ++i) {
    const Lamp& lamp = site.lamps[i];
    const auto shines = static_cast<float>(bright[i]);
    const Eigen::Vector3d at(lamp.x, lamp.y, lamp.height_m);
    as_written.push_back({at.cast<float>(), static_cast<float>(lamp.brightness), 1.0F});
    lamps_.push_back({at.cast<float>(), static_cast<float>(lamp.brightness) * shines, shines});
  }
  constexpr double as_a_lamp_m2 = 2.0;
  for (const Skylight& skylight : site.skylights) {
    const Pose2& pose = skylight.site_from_skylight;
    const Eigen::Vector3d at(pose.x, pose.y, site.hall.ceiling_m - 0.1);
    const double brightness = skylight.brightness * skylight.length_m * skylight.width_m / as_a_lamp_m2;
    skylights_.push_back({at.cast<float>(), static_cast<float>(brightness), 1.0F});
  }
  std::swap(lamps_, as_written);
  double sum = 0.0;
  int count = 0;
  for (double y = site.floor.y_min; y <= site.floor.y_max; y += 1.0) {
    for (double x = site.floor.x_min; x <= site.floor.x_max; x += 1.0, ++count)
      sum += static_cast<double>(at(Eigen::Vector3d(x, y, 0.0).cast<float>(), Eigen::Vector3f::UnitZ(), nullptr));
  }
  std::swap(lamps_, as_written);
  per_mean_ = static_cast<float>(count / std::max(1e-6, sum));
  // The mean is measured without it: a hall at night is dark, and not another day.
  change_ = static_cast<float>(site.change.light);
  ambient_ *= static_cast<float>(site.change.ambient);
  sky_ = static_cast<float>(site.change.skylight);
  for (LampNow& skylight : skylights_) skylight.brightness *= sky_;
}

float HallLight::at(const Eigen::Vector3f& point, const Eigen::Vector3f& normal, const QuadScene* in_the_way) const {
  const Eigen::Vector3f from = above(point, normal);
  float sum = ambient_;
  for (const std::vector<LampNow>* lamps : {&lamps_, &skylights_}) {
    for (const LampNow& lamp : *lamps) {
      sum += arriving(lamp.brightness * falloff(lamp.at, point, normal), lamp.at, from, in_the_way);
    }
  }
  return sum * per_mean_ * change_;
}

/// Returns which lamp a lamp's own face belongs to: the nearest.
std::size_t HallLight::lamp_at(const Quad& quad) const {
  std::size_t at = 0;
  float nearest = std::numeric_limits<float>::infinity();
  for (std::size_t i = 0; i < lamps_.size(); ++i) {
    const float away = (lamps_[i].at - quad.at(0.5F, 0.5F)).squaredNorm();
    if (away < nearest) {
      nearest = away;
      at = i;
    }
  }
  return at;
}

/// Returns the light of a lamp's own face, which shines by itself; its place tells which lamp it is.
QuadLight HallLight::of_lamp(const Quad& quad) const {
  const float shines = lamps_.empty() ? 0.0F : lamps_[lamp_at(quad)].shines;
  QuadLight light;
  light.at.fill(std::max(kDarkLampGrey, kLampGrey * shines) * change_);
  return light;
}

HallLight HallLight::at_time(double time_s) const {
  HallLight now = *this;
  for (std::size_t i = 0; i < now.lamps_.size(); ++i) {
    const auto share = static_cast<float>(share_at(as_written_[i], time_s));
    now.lamps_[i].brightness *= share;
    now.lamps_[i].shines *= share;
  }
  return now;
}

std::vector<QuadLight> HallLight::by_lamp(std::size_t lamp, std::span<const Quad> quads,
                                          const QuadScene* in_the_way) const {
  const LampNow& one = lamps_[lamp];
  std::vector<QuadLight> all(quads.size());
  for (std::size_t i = 0; i < quads.size(); ++i) {
    const Quad& quad = quads[i];
    if (quad.stuff == Stuff::skylight) continue;
    if (quad.stuff == Stuff::lamp) {
      if (lamp_at(quad) == lamp) all[i].at.fill(std::max(0.0F, kLampGrey * one.shines - kDarkLampGrey) * change_);
      continue;
    }
    const Eigen::Vector3f normal = quad.normal();
    for (std::size_t corner = 0; corner < 4; ++corner) {
      const Eigen::Vector3f point = corner_of(quad, corner);
      const float light = one.brightness * falloff(one.at, point, normal);
      all[i].at[corner] = arriving(light, one.at, above(point, normal), in_the_way) * per_mean_ * change_;
    }
  }
  return all;
}

std::vector<QuadLight> HallLight::on(std::span<const Quad> quads, const QuadScene* in_the_way) const {
  std::vector<QuadLight> all;
  all.reserve(quads.size());
  for (const Quad& quad : quads) {
    if (quad.stuff == Stuff::lamp) {
      all.push_back(of_lamp(quad));
      continue;
    }
    QuadLight light;
    if (quad.stuff == Stuff::skylight) {
      light.at.fill(kLampGrey * sky_ * change_);
      all.push_back(light);
      continue;
    }
    const Eigen::Vector3f normal = quad.normal();
    for (std::size_t corner = 0; corner < 4; ++corner)
      light.at[corner] = at(corner_of(quad, corner), normal, in_the_way);
    all.push_back(light);
  }
  return all;
}

}  // namespace weft::agents::sim
