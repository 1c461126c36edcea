#include "server/dispatcher/planning.hpp"

#include <algorithm>
#include <chrono>

#include "core/network/search.hpp"

namespace weft::server {
namespace {
using namespace std::chrono_literals;

constexpr Duration kBetweenMovePlans = 1s;
constexpr Duration kLeastBetweenPlans = 100ms;
constexpr Duration kLeastPerRobot = 5ms;
constexpr std::size_t kFewRobots = kLeastBetweenPlans / kLeastPerRobot;
/// Bounds what is done of a plan at once, in the unit of `MoveSteps`: up to 10 ms with 200 robots
/// (docs/performance.md). A small fleet on a map of some hundred places plans in one piece.
constexpr std::uint64_t kPieceOfPlan = 4000;
constexpr Duration kBetweenPieces = 1ms;
/// Bounds how long what is taught meanwhile may be left out of plans: each batch makes another map.
constexpr Duration kBetweenMaps = 10s;

/// Returns how one drives from one place to the next; none: one does not.
std::optional<Relation> hop(const Snapshot& network, const PlaceId& from, const PlaceId& to) {
  std::optional<Relation> found;
  network.for_each_edge(from, [&](const Edge& edge) {
    if (!found && other_end(edge, from) == to && can_drive(edge, from)) found = relation_from(edge, from);
  });
  return found;
}

}  // namespace

Duration least_between_plans(std::size_t robots) {
  return std::clamp<Duration>(static_cast<int>(std::min<std::size_t>(robots, 10'000)) * kLeastPerRobot,
                              kLeastBetweenPlans, kBetweenMovePlans);
}

void Planning::begin(const RuledNetwork& network, double footprint_m, std::vector<PlanRequest> requests,
                     SteadyTime now) {
  robots_.clear();
  asked_.clear();
  for (const PlanRequest& request : requests) asked_.push_back({request.robot, request.held.back(), request.goal});
  next_ = now + kBetweenMovePlans;
  soonest_ = now + least_between_plans(requests.size());
  at_once_ = requests.size() <= kFewRobots ? SteadyTime{} : soonest_;
  is_under_way_ = true;
  begun_at_ = piece_at_ = now;
  // To describe many is a piece of its own.
  if (requests.size() > kFewRobots) piece_at_ += kBetweenPieces;
  const bool may_lag = followed_at_ && now < *followed_at_ + kBetweenMaps;
  if (planner_.begin(network, footprint_m, std::move(requests), may_lag)) followed_at_ = now;
}

bool Planning::work(SteadyTime now) {
  piece_at_ = now + kBetweenPieces;
  if (planner_.is_under_way()) planner_.work(kPieceOfPlan);
  if (planner_.is_under_way()) return false;
  is_under_way_ = false;
  for (std::uint32_t number = 0; number < asked_.size(); ++number) {
    robots_[asked_[number].robot] = {number, asked_[number].end};
  }
  // Leaves as much time to the plan as it took: who is asked for another one at once would never follow any.
  const SteadyTime rested = now + (now - begun_at_);
  if (now > begun_at_) next_ = std::max(next_, rested);
  soonest_ = std::max(soonest_, rested);
  at_once_ = now > begun_at_ ? std::max(at_once_, rested) : at_once_;
  return true;
}

void Planning::leave_out(const RobotId& robot) {
  robots_.erase(robot);
  want_soon();
}

std::optional<std::uint32_t> Planning::number(const RobotId& robot, const PlaceId& end) const {
  const auto found = robots_.find(robot);
  if (found == robots_.end() || found->second.end != end) return std::nullopt;
  return found->second.number;
}

Planning::Piece Planning::piece(std::uint32_t number, const std::vector<PlaceId>& held) {
  const PlanOrder& order = planner_.order();
  const std::uint32_t first = order.released(number);
  const std::uint32_t last = planner_.may(number, planner_.berths_in(held));
  PlannedWay way = planner_.way(number, first, last);
  return {
      .places = std::move(way.places), .stops = std::move(way.stops), .has_more = last < order.moves(number).size()};
}

void Planning::released(const RobotId& robot, std::size_t stops, const PlaceId& end) {
  if (stops == 0) return leave_out(robot);
  Planned& planned = robots_.at(robot);
  planner_.release(planned.number, planner_.order().released(planned.number) + static_cast<std::uint32_t>(stops));
  planned.end = end;
}

std::set<RobotId> Planning::waits_for(std::uint32_t number) {
  std::set<RobotId> robots;
  for (const std::uint32_t other : planner_.waits_for(number)) robots.insert(asked_[other].robot);
  return robots;
}

std::optional<Route> led_by(const Snapshot& network, const Route& route, bool told,
                            const std::vector<PlaceId>& places, const std::vector<PlaceId>& tail) {
  Route next = route;
  const std::size_t kept = told ? route.released : 0;
  next.places.resize(kept + 1);
  next.relations.resize(kept);
  for (const std::vector<PlaceId>* const more : {&places, &tail}) {
    for (const PlaceId& place : *more) {
      std::optional<Relation> relation = hop(network, next.places.back(), place);
      if (!relation) return std::nullopt;
      next.relations.push_back(*std::move(relation));
      next.places.push_back(place);
    }
  }
  next.version = route.version + 1;
  next.made_of = network.revision();
  next.limits.clear();
  return next;
}

}  // namespace weft::server
