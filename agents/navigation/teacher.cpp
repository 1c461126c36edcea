#include "agents/navigation/teacher.hpp"

#include <cmath>

#include "agents/methods/advance.hpp"
#include "core/network/codec.hpp"

namespace weft::agents {

namespace {
constexpr double backwards_m = 0.05;
}

Relation Teacher::last_from_robot() const {
  return since_ ? since_->previous_from_current : Relation{Metric2{}};
}

Drivable Teacher::drivable(const Relation& last_from_kept) const {
  if (both_ways_) return Drivable::both;
  // Driven backwards, it can be driven forwards the other way.
  return planar(last_from_kept).x < -backwards_m ? Drivable::b_to_a : Drivable::a_to_b;
}

void Teacher::advance(const Step& step) {
  if (!last_) return;
  since_ = since_ ? joined(*since_, step) : step;
  since_m_ += distance_m(step.previous_from_current);
}

bool Teacher::due() const {
  if (!last_ || asked_) return true;
  if (!since_) return false;
  return distance_m(since_->previous_from_current) >= config_.spacing_m ||
         std::abs(heading_rad(since_->previous_from_current)) >= config_.spacing_rad;
}

bool Teacher::worth_an_end() const {
  if (!last_) return true;
  if (!since_) return false;
  return norm(since_->previous_from_current) >= config_.last_place_m;
}

Kept Teacher::keep(Bytes content, std::uint64_t frame, SensorTime time) {
  Kept kept;
  kept.place.id = {start_.experience, last_ ? last_->index + 1 : 0};
  kept.place.method = method_;
  kept.place.content_format = content_format_;
  kept.place.content = {hash_bytes(content), content.size()};
  kept.place.robot = start_.robot;
  kept.place.frame = frame;
  kept.place.seen_at = time;
  kept.content = std::move(content);
  if (last_) {
    Edge edge;
    edge.id = {*last_, kept.place.id};
    edge.a_from_b = last_from_robot();
    edge.origin = since_ && !since_->seen ? Origin::blind : Origin::odometry;
    edge.method = method_;
    edge.drivable = drivable(edge.a_from_b);
    kept.edges.push_back(std::move(edge));
  }
  driven_m_.push_back(driven_m_.empty() ? 0.0 : driven_m_.back() + since_m_);
  last_ = kept.place.id;
  since_.reset();
  since_m_ = 0.0;
  asked_ = false;
  return kept;
}

std::optional<Estimate> Teacher::estimate() const {
  if (!last_) return std::nullopt;
  return Estimate{*last_, last_from_robot(), since_m_};
}

}  // namespace weft::agents
