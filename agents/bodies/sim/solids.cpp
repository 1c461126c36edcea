#include "agents/bodies/sim/solids.hpp"

#include <algorithm>

#include "agents/bodies/sim/base.hpp"
#include "agents/bodies/sim/hall/movers.hpp"

namespace weft::agents::sim {
namespace {

constexpr double kPersonKeepsM = 0.3;
constexpr double kPersonLongM = 0.4, kPersonWideM = 0.64;
// Are how far a forklift reaches in its own frame (hall/movers.cpp): behind, and before without and with its forks.
constexpr double kForkliftBackM = -1.1, kForkliftMastM = 0.61, kForkliftForksM = 1.65, kForkliftWideM = 1.1;

}  // namespace

Solids::Solids(const Site& site)
    : boxes_(site.boxes),
      obstacles_(site.obstacles),
      movers_(site.movers),
      radius_m_(site.base.radius_m),
      body_height_m_(site.base.body_height_m),
      waited_s_(site.movers.size(), 0.0) {}

/// Returns where a mover stands that has gone on for so long, without what it has waited.
Solids::Footprint Solids::footprint_of(std::size_t mover, double at_s) const {
  const Mover& who = movers_[mover];
  const std::size_t thing = obstacles_.size() + mover;
  const Pose2 pose = pose_of(who, at_s);
  if (who.kind == Mover::Kind::person) return {pose, kPersonLongM, kPersonWideM, thing};
  // Forks above the robot's body let it pass under them.
  const double front_m = who.forks_m < body_height_m_ ? kForkliftForksM : kForkliftMastM;
  const Pose2 middle = pose * Pose2{(front_m + kForkliftBackM) / 2, 0.0, 0.0};
  return {middle, front_m - kForkliftBackM, kForkliftWideM, thing};
}

const std::string& Solids::name_of(const Footprint& footprint) const {
  const std::size_t thing = footprint.thing;
  return thing < obstacles_.size() ? obstacles_[thing].name : movers_[thing - obstacles_.size()].name;
}

/// Returns how far the robot there is from it, metres; negative: it is over it.
double Solids::gap_m(const Footprint& it, const Pose2& robot) const {
  return distance_to_rim(it.site_from_middle, it.length_m, it.width_m, robot.x, robot.y) - radius_m_;
}

/// Returns whether a mover would rather stand than go on for so long.
bool Solids::waits(std::size_t mover, const Pose2& site_from_robot, double duration_s) const {
  const Mover& who = movers_[mover];
  if (who.kind != Mover::Kind::person || who.is_rude || !who.is_solid) return false;
  const double at_s = now_s_ - waited_s_[mover];
  const double next_m = gap_m(footprint_of(mover, at_s + duration_s), site_from_robot);
  return next_m < kPersonKeepsM && next_m < gap_m(footprint_of(mover, at_s), site_from_robot);
}

void Solids::advance(const Pose2& site_from_robot, double duration_s) {
  for (std::size_t i = 0; i < movers_.size(); ++i)
    if (waits(i, site_from_robot, duration_s)) waited_s_[i] += duration_s;
  now_s_ += duration_s;
  stand_now();
}

void Solids::stand_now() {
  now_.clear();
  for (std::size_t i = 0; i < obstacles_.size(); ++i) {
    const Obstacle& o = obstacles_[i];
    if (o.stands_at(now_s_)) now_.push_back({o.site_from_obstacle, o.length_m, o.width_m, i});
  }
  for (std::size_t i = 0; i < movers_.size(); ++i)
    if (movers_[i].is_solid) now_.push_back(footprint_of(i, now_s_ - waited_s_[i]));
}

const Box* Solids::touched_box(const Pose2& robot) const {
  const auto touched = std::find_if(boxes_.begin(), boxes_.end(),
                                    [&](const Box& box) { return distance_to(box, robot.x, robot.y) < radius_m_; });
  return touched == boxes_.end() ? nullptr : &*touched;
}

const std::string* Solids::in_the_way(const Pose2& from, const Pose2& to) const {
  if (const Box* const box = touched_box(to); box != nullptr && touched_box(from) == nullptr) return &box->name;
  for (const Footprint& footprint : now_) {
    const double gap = gap_m(footprint, to);
    if (gap < 0.0 && gap < gap_m(footprint, from)) return &name_of(footprint);
  }
  return nullptr;
}

const std::string* Solids::touching(const Pose2& site_from_robot) const {
  const auto over = std::find_if(now_.begin(), now_.end(),
                                 [&](const Footprint& footprint) { return gap_m(footprint, site_from_robot) < 0.0; });
  return over == now_.end() ? nullptr : &name_of(*over);
}

}  // namespace weft::agents::sim
