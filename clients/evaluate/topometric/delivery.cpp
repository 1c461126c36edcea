#include "clients/evaluate/topometric/delivery.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/network/search.hpp"

namespace weft::evaluate::topometric {
namespace {

using namespace agents;

constexpr double kBlockedForS = 2.0;   // then it says so (agents/agent/blocked_watch.cpp)
constexpr double kEndsAfterS = 30.0;   // then its route ends (server/dispatcher/blocked.cpp)
constexpr double kStandsForS = 60.0;   // then it has given up
constexpr double kRestsForS = 1.0;     // after arriving, for the base to come to rest
constexpr std::size_t kMostPlans = 8;  // for one goal

Snapshot without(const Snapshot& snapshot, const std::set<EdgeId>& closed) {
  Snapshot::Experiences experiences = snapshot.experiences();
  for (auto& [id, shared] : experiences) {
    Experience open = *shared;
    const auto is_open = [&](const Edge& edge) { return !closed.contains(edge.id); };
    std::vector<Edge> chain;
    std::copy_if(open.chain.begin(), open.chain.end(), std::back_inserter(chain), is_open);
    open.chain = SharedRow<Edge>(std::move(chain));
    open.stitches.erase_if([&](const Edge& edge) { return closed.contains(edge.id); });
    index_stitches(open);
    shared = std::make_shared<const Experience>(std::move(open));
  }
  return {snapshot.revision(), std::move(experiences), snapshot.shared_labels()};
}

/// Drives one robot to one goal.
class Delivering {
 public:
  Delivering(Ride& ride, const Rider& rider, const Taught& taught, const DeliveryLimits& limits, Delivery& delivery)
      : ride_(ride), rider_(rider), taught_(taught), limits_(limits), delivery_(delivery) {}

  /// False: stopped.
  Result<bool> drive() {
    delivery_.from_sample = ride_.samples();
    began_s_ = ride_.now_s();
    if (!plan()) return true;
    while (true) {
      if (rider_.asked_to_stop()) return false;
      const auto stepped = ride_.step(taught_.map);
      if (!stepped) return fail(stepped.error());
      delivery_.to_sample = ride_.samples() - 1;
      if (is_over(stepped->navigated)) return true;
    }
  }

 private:
  /// Gives the robot a route from where it believes to be. False: there is none, or it does not know where it is.
  bool plan() {
    const std::optional<Estimate> here = ride_.navigator().estimate();
    if (!here) return end("does not know where it is: " + ride_.last_refused());
    const Result<Route> route = route_without(taught_, here->place, delivery_.goal, closed_);
    if (!route) return end("no way");
    route_ = *route;
    if (delivery_.plans++ == 0) delivery_.route_m = metres_of(route_);
    ride_.navigator().follow(route_);
    stands_since_s_ = ride_.now_s();
    blocked_since_s_.reset();
    says_blocked_ = false;
    return true;
  }

  bool end(const std::string& why) {
    delivery_.ended = why;
    ride_.navigator().stop();
    return false;
  }

  bool is_over(const Navigated& now) {
    const double now_s = ride_.now_s();
    if (now.following == Following::arrived) {
      if (!arrived_s_) arrived_s_ = now_s;
      delivery_.has_arrived = now_s - *arrived_s_ >= kRestsForS;
      return delivery_.has_arrived;
    }
    arrived_s_.reset();
    if (now.command != Twist{}) stands_since_s_ = now_s;
    if (delivery_.blocked_sample)
      driven_after_m_ += planar(ride_.noted().step.previous_from_current).translation().norm();
    if (driven_after_m_ > limits_.most_m_after_blocked) return !end("driven far enough");
    if (now_s - began_s_ > limits_.most_s) return !end("takes too long");
    if (is_blocked(now)) return !plan_round(now);
    if (now.following == Following::failed) return !plan_again(now.reason);
    if (now_s - stands_since_s_ > kStandsForS) return !end(why_it_stands(now));
    return false;
  }

  std::string why_it_stands(const Navigated& now) const {
    if (!now.lost) return "stands: " + std::string(now.reason);
    return "stands: lost: " + ride_.last_refused();
  }

  /// Notes when something has stood in its way for long enough to say so. Returns whether its route ends by that.
  bool is_blocked(const Navigated& now) {
    if (now.reason != "blocked") {
      blocked_since_s_.reset();
      says_blocked_ = false;
      return false;
    }
    const double now_s = ride_.now_s();
    if (!blocked_since_s_) blocked_since_s_ = now_s;
    const double for_s = now_s - *blocked_since_s_;
    const bool has_failed = now.following == Following::failed;
    if (for_s >= kBlockedForS || has_failed) say_blocked();
    return for_s >= kEndsAfterS || has_failed;
  }

  void say_blocked() {
    if (std::exchange(says_blocked_, true)) return;
    ++delivery_.blocked;
    if (!delivery_.blocked_sample) delivery_.blocked_sample = ride_.samples() - 1;
  }

  bool plan_round(const Navigated& now) {
    const std::size_t at = now.route_at;
    if (at + 1 < route_.places.size()) {
      closed_.insert({route_.places[at], route_.places[at + 1]});
      closed_.insert({route_.places[at + 1], route_.places[at]});
    }
    return plan_again("blocked");
  }

  bool plan_again(std::string_view why) {
    if (delivery_.plans >= kMostPlans) return end(std::string(why));
    return plan();
  }

  Ride& ride_;
  const Rider& rider_;
  const Taught& taught_;
  DeliveryLimits limits_;
  Delivery& delivery_;
  Route route_;
  std::set<EdgeId> closed_;
  double began_s_ = 0.0;
  double stands_since_s_ = 0.0;
  double driven_after_m_ = 0.0;
  std::optional<double> arrived_s_;
  std::optional<double> blocked_since_s_;
  bool says_blocked_ = false;
};

}  // namespace

double metres_of(const Route& route) {
  double sum_m = 0.0;
  for (const Relation& relation : route.relations) sum_m += distance_m(relation);
  return sum_m;
}

Result<Route> route_without(const Taught& taught, const PlaceId& from, const PlaceId& to,
                            const std::set<EdgeId>& closed) {
  if (closed.empty()) return taught.map.route(from, to, Topometric::name);
  const Result<Path> path =
      shortest_path(without(taught.map.snapshot(), closed), from, to, {std::string(Topometric::name)});
  if (!path) return fail(path.error());
  Route route;
  route.id.bytes[0] = static_cast<std::uint8_t>(1 + closed.size());
  route.places = path->places;
  route.relations = path->relations;
  route.released = static_cast<std::uint32_t>(path->places.size() - 1);
  return route;
}

Result<std::optional<bool>> find_itself(Ride& ride, const Rider& rider, const Taught& taught,
                                        const std::optional<PlaceId>& told, double within_s) {
  if (const Result<void> signs = ride.learn_signs(taught.map); !signs) return fail(signs.error());
  ride.navigator().seek(told);
  const double began_s = ride.now_s();
  while (ride.now_s() - began_s <= within_s) {
    if (rider.asked_to_stop()) return std::optional<bool>();
    if (const auto stepped = ride.step(taught.map); !stepped) return fail(stepped.error());
    if (ride.navigator().estimate()) return std::optional(true);
  }
  return std::optional(false);
}

Result<std::optional<Delivery>> deliver(Ride& ride, const Rider& rider, const Taught& taught, const PlaceId& goal,
                                        const DeliveryLimits& limits) {
  Delivery delivery;
  delivery.goal = goal;
  const Result<bool> driven = Delivering(ride, rider, taught, limits, delivery).drive();
  if (!driven) return fail(driven.error());
  if (!*driven) return std::optional<Delivery>();
  return std::optional(std::move(delivery));
}

}  // namespace weft::evaluate::topometric
