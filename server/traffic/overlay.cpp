#include "server/traffic/overlay.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/network/rules.hpp"
#include "core/text.hpp"

namespace weft::server {
namespace {
using namespace std::chrono_literals;

constexpr Duration kClosedFor = 10min;
/// Bounds from below how far before the middle of the robot the first hop ends that is closed: its body is there, and
/// most stop before they touch. What leaves the route nearer than that may be a way round.
constexpr double kInFront_m = 0.8;
/// Bounds from below how long the stretch is: a robot that comes up to the same thing once more, a little farther,
/// has not driven it.
constexpr double kClosedLength_m = 0.8;

/// Returns whether the robot has come out of what is closed, having driven it up to its end.
bool has_left(const ClosedHops& hops, const Route& route, std::uint32_t from, std::uint32_t to) {
  const std::uint32_t last = std::min(to, static_cast<std::uint32_t>(route.places.size() - 1));
  for (std::uint32_t at = std::max(from, 1U); at < last; ++at) {
    const bool is_inside = hops.contains({route.places[at - 1], route.places[at]});
    if (is_inside && !hops.contains({route.places[at], route.places[at + 1]})) return true;
  }
  return false;
}

template <class OfKey, class Key>
const ClosedHops* closed_in(const std::map<Key, OfKey>& all, const Key& key) {
  const auto found = all.find(key);
  return found == all.end() ? nullptr : &found->second.all;
}

}  // namespace

const Closure& Overlay::Closed::add(const Closure& closure) {
  all.insert(closure.hops.begin(), closure.hops.end());
  return closures.emplace_back(closure);
}

const Closure* Overlay::close(const Snapshot& network, const Route& route, std::uint32_t at,
                              const std::string& found_by, ClosedFor whom, Now now) {
  if (route.places.size() < 2) return nullptr;
  const auto last = static_cast<std::uint32_t>(route.places.size() - 1);
  std::uint32_t first = std::min(at, last - 1);
  double ahead_m = distance_m(route.relations[first]);
  while (ahead_m <= kInFront_m && first + 1 < last) ahead_m += distance_m(route.relations[++first]);
  std::uint32_t end = first + 1;
  double length_m = distance_m(route.relations[first]);
  while (length_m < kClosedLength_m && end < last) length_m += distance_m(route.relations[end++]);
  const std::vector<PlaceId> way(route.places.begin() + first, route.places.begin() + end + 1);
  const Closure closure{.from = way.front(),
                        .to = way.back(),
                        .whom = whom,
                        .hops = hops_on_the_floor_of(network, way),
                        .found_by = found_by,
                        .since = now.wall,
                        .until = now.steady + kClosedFor,
                        .until_wall = now.wall + kClosedFor};
  const Closure& of_robot = robots_[route.robot].add(closure);
  return whom == ClosedFor::goal ? &goals_[route.goal].add(closure) : &of_robot;
}

const ClosedHops* Overlay::closed(const GoalId& goal) const {
  return closed_in(goals_, goal);
}

const ClosedHops* Overlay::closed(const RobotId& robot) const {
  return closed_in(robots_, robot);
}

const std::vector<Closure>& Overlay::of(const GoalId& goal) const {
  static const std::vector<Closure> kNone;
  const auto found = goals_.find(goal);
  return found == goals_.end() ? kNone : found->second.closures;
}

template <class IsOver>
std::vector<Overlay::Opened> Overlay::take(IsOver&& is_over) {
  std::vector<Opened> opened;
  const auto open = [&is_over](auto& all, auto&& say) {
    for (auto& [key, closed] : all) {
      Closed left;
      for (const Closure& closure : closed.closures) {
        if (is_over(closure)) {
          say(key, closure);
        } else {
          left.add(closure);
        }
      }
      closed = std::move(left);
    }
    std::erase_if(all, [](const auto& entry) { return entry.second.closures.empty(); });
  };
  open(goals_, [&opened](const GoalId& goal, const Closure& closure) { opened.push_back({goal, closure}); });
  open(robots_, [](const RobotId&, const Closure&) {});
  return opened;
}

std::vector<Overlay::Opened> Overlay::take_over(SteadyTime now) {
  if (const std::optional<SteadyTime> first = next(); !first || now < *first) return {};
  return take([now](const Closure& closure) { return closure.until <= now; });
}

std::vector<Overlay::Opened> Overlay::take_driven(const Route& route, std::uint32_t from, std::uint32_t to) {
  if (empty() || to <= from) return {};
  return take([&](const Closure& closure) { return has_left(closure.hops, route, from, to); });
}

std::optional<SteadyTime> Overlay::next() const {
  std::optional<SteadyTime> next;
  // A robot's closures are all that there are: those for goals end with them, or before.
  for (const auto& [id, robot] : robots_) {
    for (const Closure& closure : robot.closures) next = std::min(next.value_or(closure.until), closure.until);
  }
  return next;
}

std::string text_of(const Closure& closure) {
  return closure.found_by + " found the way blocked between " + to_string(closure.from) + " and " +
         to_string(closure.to) + " at " + iso_time(closure.since) + "; that is closed for " +
         (closure.whom == ClosedFor::goal ? "this goal" : "what it is asked for by the server") + " until " +
         iso_time(closure.until_wall);
}

}  // namespace weft::server
