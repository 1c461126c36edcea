#include "agents/navigation/teacher.hpp"

#include <cmath>

#include "agents/navigation/belief.hpp"
#include "core/network/codec.hpp"

namespace weft::agents {

namespace {
constexpr double backwards_m = 0.05;
}

void Teacher::advance(const Step& step) {
  if (!last_) return;
  last_from_robot_ =
      last_from_robot_ ? compose(*last_from_robot_, step.previous_from_current) : step.previous_from_current;
  since_m_ += distance_m(step.previous_from_current);
  blind_ = blind_ || !step.seen;
}

bool Teacher::due() const {
  if (!last_ || asked_) return true;
  if (!last_from_robot_) return false;
  return distance_m(*last_from_robot_) >= config_.spacing_m ||
         std::abs(heading_rad(*last_from_robot_)) >= config_.spacing_rad;
}

bool Teacher::worth_an_end() const {
  if (!last_) return true;
  if (!last_from_robot_) return false;
  return norm(*last_from_robot_) >= config_.last_place_m;
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
    edge.a_from_b = last_from_robot_.value_or(Relation{Metric2{}});
    edge.origin = blind_ ? Origin::blind : Origin::odometry;
    edge.method = method_;
    // Driven backwards, it can be driven forwards the other way.
    edge.drivable = planar(edge.a_from_b).x < -backwards_m ? Drivable::b_to_a : Drivable::a_to_b;
    kept.edges.push_back(std::move(edge));
  }
  driven_m_.push_back(driven_m_.empty() ? 0.0 : driven_m_.back() + since_m_);
  last_ = kept.place.id;
  last_from_robot_.reset();
  since_m_ = 0.0;
  blind_ = false;
  asked_ = false;
  return kept;
}

std::optional<Estimate> Teacher::estimate() const {
  if (!last_) return std::nullopt;
  return Estimate{*last_, last_from_robot_.value_or(Relation{Metric2{}}), since_m_};
}

}  // namespace weft::agents
