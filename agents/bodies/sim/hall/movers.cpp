#include "agents/bodies/sim/hall/movers.hpp"

#include <algorithm>
#include <cmath>

#include "agents/bodies/sim/hall/shape.hpp"

namespace weft::agents::sim {
namespace {

void add_forklift(const Pose2& pose, std::uint32_t who, double forks_m, std::vector<Quad>& quads) {
  constexpr double lowered_mast_m = 2.3;
  constexpr double pallet_m = 0.15;
  const double mast_m = std::max(lowered_mast_m, forks_m + 1.2);
  const Shape shape{pose, quads};
  shape.add(-0.3, 0.0, 0.15, 1.6, 1.1, 0.75, painted(Stuff::vehicle, 150.0F, who));
  shape.add(-0.8, 0.0, 0.9, 0.6, 1.0, 0.5, painted(Stuff::vehicle, 70.0F, who + 1));
  for (const double side : {-0.5, 0.5})
    shape.add(0.55, side * 0.7, 0.0, 0.12, 0.1, mast_m, painted(Stuff::steel, 50.0F, who));
  shape.add(-0.4, 0.0, 2.1, 1.1, 1.0, 0.06, painted(Stuff::vehicle, 60.0F, who + 2));
  shape.add(1.15, 0.0, forks_m, 1.0, 0.9, 0.144, painted(Stuff::pallet, 100.0F, who));
  shape.add(1.15, 0.0, forks_m + pallet_m, 1.0, 0.9, 0.9, painted(Stuff::load, 115.0F, who * 13 + 5));
}

double length_of(const std::vector<SitePoint>& way) {
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) length += std::hypot(way[i].x - way[i - 1].x, way[i].y - way[i - 1].y);
  return length;
}

}  // namespace

Pose2 pose_of(const Mover& mover, double time_s) {
  const double length = length_of(mover.way);
  double along = std::fmod(mover.speed_m_s * time_s + mover.begins_m, 2.0 * length);
  const bool is_back = along > length;
  if (is_back) along = 2.0 * length - along;
  for (std::size_t i = 1; i < mover.way.size(); ++i) {
    const SitePoint& from = mover.way[i - 1];
    const SitePoint& to = mover.way[i];
    const double leg = std::hypot(to.x - from.x, to.y - from.y);
    if (along > leg && i + 1 < mover.way.size()) {
      along -= leg;
      continue;
    }
    const double share = leg > 0.0 ? std::min(1.0, along / leg) : 0.0;
    const double heading = std::atan2(to.y - from.y, to.x - from.x) + (is_back ? M_PI : 0.0);
    return {from.x + share * (to.x - from.x), from.y + share * (to.y - from.y), wrap_angle(heading)};
  }
  return {mover.way.front().x, mover.way.front().y, 0.0};
}

void add_person(const Pose2& pose, std::uint32_t who, double walked_m, std::vector<Quad>& quads) {
  const Shape shape{pose, quads};
  const double stride = 0.22 * std::sin(walked_m * 2.0 * M_PI / 1.4);
  const auto trousers = static_cast<float>(35 + who * 37 % 80);
  const auto jacket = static_cast<float>(60 + who * 61 % 150);
  for (const double side : {-1.0, 1.0})
    shape.add(side * stride, side * 0.1, 0.0, 0.16, 0.15, 0.85, painted(Stuff::clothing, trousers, who));
  shape.add(0.0, 0.0, 0.85, 0.24, 0.44, 0.6, painted(Stuff::clothing, jacket, who + 7));
  for (const double side : {-1.0, 1.0})
    shape.add(-side * stride, side * 0.27, 0.8, 0.12, 0.1, 0.6, painted(Stuff::clothing, jacket * 0.9F, who + 9));
  shape.add(0.0, 0.0, 1.5, 0.2, 0.17, 0.24, painted(Stuff::clothing, 120.0F, who + 11));
}

void add_mover(const Mover& mover, std::uint32_t who, double time_s, std::vector<Quad>& quads) {
  const Pose2 pose = pose_of(mover, time_s);
  if (mover.kind == Mover::Kind::person) {
    add_person(pose, who, mover.speed_m_s * time_s + mover.begins_m, quads);
  } else {
    add_forklift(pose, who, mover.forks_m, quads);
  }
}

}  // namespace weft::agents::sim
