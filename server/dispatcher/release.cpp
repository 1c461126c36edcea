#include <algorithm>
#include <utility>

#include "server/dispatcher/capacity.hpp"
#include "server/dispatcher/dispatcher.hpp"

/// Releases routes, a piece at a time, in the order of the plan.
namespace weft::server {
namespace {

/// Is a whole fleet, where that is planned for at each change (least_between_plans).
constexpr std::size_t kReleasesAtOnce = 20;

/// Returns whether the route goes on with these places.
bool leads_along(const Route& route, std::size_t kept, const std::vector<PlaceId>& places) {
  if (route.places.size() - kept - 1 < places.size()) return false;
  return std::equal(places.begin(), places.end(), route.places.begin() + static_cast<std::ptrdiff_t>(kept) + 1);
}

}  // namespace

/// Follows the plan: has robots make way, and looks at releases that may grow, a few of all at once, as each may take
/// a search of its own. The others come next, from the robot on where this ends.
void Dispatcher::release_some(Now now) {
  if (planning_.is_under_way()) return;
  std::size_t left = kReleasesAtOnce;
  for (; left > 0 && !to_make_way_.empty(); --left) {
    const RobotId robot = to_make_way_.front();
    to_make_way_.pop_front();
    ask_to_make_way(robot, now);
  }
  auto next = release_from_ ? assignments_.lower_bound(*release_from_) : assignments_.begin();
  release_from_.reset();
  for (; next != assignments_.end(); ++next) {
    auto& [robot, assignment] = *next;
    if (!assignment.look_at_release || assignment.is_lost()) continue;
    if (left == 0) {
      release_from_ = robot;
      return;
    }
    if (release(robot, assignment, now)) --left;
  }
}

/// Releases the route as far as it is the robot's turn and nobody holds it: what is granted is stored before it is
/// sent. Returns whether it was looked at for that.
bool Dispatcher::release(const RobotId& robot, RouteAssignment& assignment, Now now) {
  if (!is_led(assignment)) return false;
  const Goal& goal = *book_.find(assignment.goal);
  const Route& route = *book_.route(assignment.goal);
  const bool told = is_told(robot, route);
  const bool is_all = told && route.released + 1 == route.places.size();
  // Lets a yield grow, unless an operator waits for the robot.
  if (is_all && (goal.kind != GoalKind::yield || is_waited_for(robot))) return false;
  if (!std::exchange(assignment.look_at_release, false)) return false;
  if (const std::string why = why_held(robot); !why.empty()) {
    wait_for(goal, why, now);
    return true;
  }
  std::optional<Piece> piece = next_piece(robot, goal, route, told, now);
  if (!piece) return true;
  assignment.ruled_by = end_by_rules(robot, told ? route.released : 0, told, *piece);
  if (piece->way.through) {
    grant(robot, assignment, *piece, told, now);
  } else if (told && !is_all) {
    const std::string reason = assignment.ruled_by.empty() ? why_it_stands(piece->way)
                                                           : "waits as rule " + assignment.ruled_by + " keeps it";
    if (route.reason != reason) {
      Route next = route;
      next.reason = reason;
      if (book_.write(next, {}, now)) {
        assignment.wait = Duration{};
        send_order(robot, assignment, now.steady);
      }
    }
  }
  if (is_all) return true;
  assignment.way = piece->way;
  if (!assignment.waits_since) assignment.waits_since = now;
  // Mostly it is let on while it still drives: then it does not wait.
  const bool drives_on = told && !assignment.stands_at_end;
  note_waiting(robot, assignment, drives_on ? Traffic::Way{} : piece->way, now);
  return true;
}

/// Finds what comes next by the plan, and how far that can be had. None: the robot is not where the plan has it, and
/// there will be another one.
std::optional<Dispatcher::Piece> Dispatcher::next_piece(const RobotId& robot, const Goal& goal, const Route& route,
                                                        bool told, Now now) {
  const std::size_t kept = told ? route.released : 0;
  const std::optional<std::uint32_t> number = planning_.number(robot, route.places[kept]);
  if (!number) {
    if (planning_.has(robot)) planning_.want_soon();
    return std::nullopt;
  }
  Piece piece{.route = route, .stops = {}, .way = {}, .reach = {}};
  std::vector<PlaceId> held = {route.places[kept]};
  if (const storage::PutOccupancy* const holds = traffic_.held(robot); told && holds != nullptr) {
    held.assign(holds->held.places.begin() + holds->from, holds->held.places.begin() + holds->to + 1);
  }
  const Planning::Piece planned = planning_.piece(*number, held);
  const std::optional<Route> led = led_along(goal, route, told, planned.places, now);
  if (led && !planned.stops.empty()) {
    piece.route = *led;
    for (const std::uint32_t stop : planned.stops) piece.stops.push_back(static_cast<std::uint32_t>(kept) + 1 + stop);
    piece.way = traffic_.way(piece.route, told ? route.released + 1 : 0, &piece.stops);
    if (!planned.has_more) name_what_is_beyond(piece);
    return piece;
  }
  if (told && route.released + 1 == route.places.size()) return piece;
  // Nothing is planned, or others come first: who is in the way is told all the same. A robot that stands within what
  // another one holds may get out of it.
  piece.way = traffic_.way(route, told ? route.released + 1 : 0);
  piece.reach = piece.way.through;
  const bool is_there = !told && route.places.size() == 1;
  const std::vector<PlaceId> ahead(route.places.begin() + static_cast<std::ptrdiff_t>(kept) + 1, route.places.end());
  const bool gets_out = piece.way.is_away && planning_.is_safe(*number, ahead);
  if (!gets_out && !is_there) piece.way.through.reset();
  if (piece.way.end == Traffic::Way::End::free) {
    piece.way.end = Traffic::Way::End::turn;
    piece.way.blocked_by = planning_.waits_for(*number);
    if (kept + 1 < route.places.size()) piece.way.needs.place = route.places[kept + 1];
  }
  if (const std::optional<RobotId> by = planning_.cut_off_by(*number); by && !piece.way.through)
    name_who_cuts_off(piece, *by, kept);
  return piece;
}

/// Says that the robot waits for the one that cuts it off from its goal: who else is on its way is led on once it can
/// come there.
void Dispatcher::name_who_cuts_off(Piece& piece, const RobotId& by, std::size_t kept) {
  const std::optional<Touched> needs = traffic_.first_held_by(by, piece.route, static_cast<std::uint32_t>(kept) + 1);
  if (!needs) return;
  piece.way = {.through = std::nullopt, .end = Traffic::Way::End::held, .blocked_by = {by}, .needs = *needs};
}

/// Says who is in the way beyond what is planned, where the plan ends before the route does.
void Dispatcher::name_what_is_beyond(Piece& piece) {
  const bool is_planned = piece.way.through == piece.stops.back() && piece.way.end == Traffic::Way::End::free;
  if (!is_planned || piece.stops.back() + 1 == piece.route.places.size()) return;
  Traffic::Way beyond = traffic_.way(piece.route, piece.stops.back() + 1);
  beyond.through = piece.way.through;
  if (beyond.end == Traffic::Way::End::held) piece.way = std::move(beyond);
}

/// Returns the route with the places that are planned: itself, when it leads so, or its next version, which goes on
/// to the goal from where the plan ends.
std::optional<Route> Dispatcher::led_along(const Goal& goal, const Route& route, bool told,
                                           const std::vector<PlaceId>& places, Now now) {
  if (places.empty()) return std::nullopt;
  const std::size_t kept = told ? route.released : 0;
  if (leads_along(route, kept, places)) return route;
  std::vector<PlaceId> tail;
  if (goal.kind != GoalKind::yield) {
    const auto ahead =
        std::find(route.places.begin() + static_cast<std::ptrdiff_t>(kept) + 1, route.places.end(), places.back());
    if (ahead != route.places.end()) {
      tail.assign(ahead + 1, route.places.end());
    } else {
      const Robot* const known = fleet_.find(route.robot);
      if (known == nullptr || !known->description) return std::nullopt;
      const Result<Path> way =
          routes_.find_allowed(places.back(), route.places.back(), methods_of(*known),
                               known->description->knows_limits, now.steady, closed_for(goal, route.robot));
      if (!way) return std::nullopt;
      tail.assign(way->places.begin() + 1, way->places.end());
    }
  }
  return led_by(context_.snapshots.current(), route, told, places, tail);
}

/// Stores the piece and sends it.
void Dispatcher::grant(const RobotId& robot, RouteAssignment& assignment, const Piece& piece, bool told, Now now) {
  Route next = piece.route;
  const bool is_other_way = next.version != book_.route(assignment.goal)->version;
  next.released = *piece.way.through;
  next.reason =
      assignment.ruled_by.empty() ? why_it_stands(piece.way) : "waits as rule " + assignment.ruled_by + " keeps it";
  if (book_.find(assignment.goal)->kind == GoalKind::yield) {
    next.places.resize(next.released + std::size_t{1});
    next.relations.resize(next.released);
  }
  if (is_other_way) next.limits = limits_of(routes_.rules(), next.places);
  const std::uint32_t from = told ? traffic_.held(robot)->from : 0;
  const std::vector<storage::PutOccupancy> claims = traffic_.claim(next, from, next.released);
  storage::Transaction transaction;
  for (const storage::PutOccupancy& claim : claims) transaction.changes.emplace_back(claim);
  if (!book_.write(next, std::move(transaction), now)) {
    assignment.look_at_release = true;
    return;
  }
  traffic_.committed(claims);
  if (is_other_way) assignment.latest_report.reset();
  assignment.has_latest_order = false;
  assignment.stands_at_end = false;
  assignment.waits_since.reset();
  assignment.wait = Duration{};
  const auto stop = std::find(piece.stops.begin(), piece.stops.end(), next.released);
  const std::size_t given = stop == piece.stops.end() ? 0 : static_cast<std::size_t>(stop - piece.stops.begin()) + 1;
  planning_.released(robot, given, next.places[next.released]);
  // Others may follow.
  for (auto& [other, waiting] : assignments_) waiting.look_at_release = waiting.look_at_release || other != robot;
  send_order(robot, assignment, now.steady);
}

/// Returns what the robot's order says of why it goes no farther; empty: it does.
std::string Dispatcher::why_it_stands(const Traffic::Way& way) const {
  if (!way.blocked_by.empty()) return "waits for " + names_of(way.blocked_by);
  return way.end == Traffic::Way::End::not_laid ? "waits until the map is laid out" : "";
}

std::string Dispatcher::names_of(const std::set<RobotId>& robots) const {
  std::string names;
  std::size_t left = robots.size();
  for (const RobotId& robot : robots) {
    names += fleet_.name_of(robot);
    if (--left > 0) names += left > 1 ? ", " : " and ";
  }
  return names;
}

std::string Dispatcher::why_it_waits(const Traffic::Way& way) const {
  const std::string have = way.blocked_by.size() > 1 ? " have" : " has";
  switch (way.end) {
    case Traffic::Way::End::held:
      return names_of(way.blocked_by) + have + " left its way";
    case Traffic::Way::End::turn:
      if (way.blocked_by.empty()) return "the plan of everybody's moves lets it go on";
      return names_of(way.blocked_by) + have + " come by first";
    case Traffic::Way::End::one_at_once:
      return names_of(way.blocked_by) +
             " has arrived: robots are in parts of the map that nothing joins, and one drives at a time";
    default:
      return "it is laid out where the places of the map lie";
  }
}

std::string Dispatcher::why_it_goes_on(const Traffic::Way& way) const {
  switch (way.end) {
    case Traffic::Way::End::held:
      return names_of(way.blocked_by) + (way.blocked_by.size() > 1 ? " have" : " has") + " left the way";
    case Traffic::Way::End::turn:
      return "it is its turn";
    case Traffic::Way::End::one_at_once:
      return names_of(way.blocked_by) + " is not on its way any more, or all robots are in one part of the map";
    default:
      return "it is laid out where the places of the map lie";
  }
}

void Dispatcher::note_waiting(const RobotId& robot, RouteAssignment& assignment, const Traffic::Way& way, Now now) {
  const std::string& rule = assignment.ruled_by;
  if (assignment.noted_way.ends_alike(way) && assignment.noted_rule == rule) return;
  const Traffic::Way before = std::exchange(assignment.noted_way, way);
  const std::string rule_before = std::exchange(assignment.noted_rule, rule);
  const Goal& goal = *book_.find(assignment.goal);
  const bool waits = way.end != Traffic::Way::End::free || !rule.empty();
  const std::string cause = !rule.empty()
                                ? fleet_.name_of(robot) + " waits until rule " + rule + " lets it on: weft rule list"
                            : waits                ? fleet_.name_of(robot) + " waits until " + why_it_waits(way)
                            : !rule_before.empty() ? "rule " + rule_before + " lets it on"
                                                   : why_it_goes_on(before);
  // Lost only if the store takes nothing; the next change is told again.
  std::ignore = book_.write(
      goal, {.state = goal.state, .cause = cause, .who = "traffic", .kind = waits ? "goal.waits" : "goal.goes_on"},
      std::nullopt, {}, now);
}

bool Dispatcher::keeps_limits(const RobotId& robot) const {
  const Robot* const known = fleet_.find(robot);
  return known != nullptr && known->description && known->description->knows_limits;
}

/// Returns what everybody else holds, where rules count robots.
HeldPlaces Dispatcher::held_by_others(const RobotId& robot) const {
  HeldPlaces others;
  if (!routes_.rules().counts_robots()) return others;
  for (const RobotId& other : traffic_.holding()) {
    if (other == robot) continue;
    const storage::PutOccupancy& held = *traffic_.held(other);
    const auto begin = held.held.places.begin();
    others[other].assign(begin + held.from, begin + held.to + 1);
  }
  return others;
}

/// Ends the piece where rules do, at a stop. Returns the name of the rule that ends it; empty: none does.
std::string Dispatcher::end_by_rules(const RobotId& robot, std::uint32_t kept, bool told, Piece& piece) const {
  const std::optional<std::uint32_t> most = piece.way.through ? piece.way.through : piece.reach;
  ReleasedByRules ruled = released_by_rules(routes_.rules(), piece.route, kept, most, keeps_limits(robot));
  const ReleasedByRules full =
      released_by_capacity(routes_.rules(), piece.route, kept, ruled.through, held_by_others(robot));
  if (!full.rule.empty()) ruled = full;
  if (ruled.rule.empty() || !piece.way.through || piece.way.is_away) return ruled.rule;
  const std::uint32_t allowed = ruled.through.value_or(kept);
  const auto beyond = std::upper_bound(piece.stops.begin(), piece.stops.end(), allowed);
  piece.way.through.reset();
  if (beyond != piece.stops.begin()) piece.way.through = *std::prev(beyond);
  // Also who stands off the berths may stand where it does.
  if (!told && !piece.way.through) piece.way.through = 0;
  return ruled.rule;
}

}  // namespace weft::server
