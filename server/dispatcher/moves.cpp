#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "server/dispatcher/dispatcher.hpp"

/// Has everybody's moves planned, and asks robots to make way that have no goal.
namespace weft::server {
namespace {
constexpr double kBerth_s = 2.3;  ///< takes a robot from one berth to the next
}  // namespace

/// Returns whether there is a release that a plan may let grow.
bool Dispatcher::needs_plan() const {
  return std::any_of(assignments_.begin(), assignments_.end(), [this](const auto& entry) {
    const auto& [robot, assignment] = entry;
    if (!is_led(assignment)) return false;
    const Route& route = *book_.route(assignment.goal);
    return !is_told(robot, route) || route.released + 1 < route.places.size();
  });
}

/// Returns whether the robot follows its route and can be released farther.
bool Dispatcher::is_led(const RouteAssignment& assignment) const {
  const bool is_followed = assignment.standing == RouteAssignment::Standing::followed && !assignment.cut_short;
  return is_followed && book_.find(assignment.goal)->state != GoalState::paused;
}

/// Returns whether a goal waits for that robot alone.
bool Dispatcher::is_waited_for(const RobotId& robot) const {
  return std::any_of(book_.alive().begin(), book_.alive().end(), [&](const auto& entry) {
    const Goal& goal = *book_.find(entry.second);
    return goal.state == GoalState::pending && goal.wanted == robot;
  });
}

/// Makes the next piece of the plan, and of a new one where none is under way.
void Dispatcher::plan_moves(Now now) {
  if (!planning_.is_under_way()) begin_plan(now);
  if (!planning_.is_due(now.steady) || !planning_.work(now.steady)) return;
  for (auto& [robot, assignment] : assignments_) assignment.look_at_release = true;
  release_from_.reset();
  for (const Planning::Asked& asked : planning_.asked()) {
    // Messages were heard meanwhile. Who stands elsewhere by now is found to do so when it is to be released.
    if (asked.goal && asked.goal != led_to(asked.robot)) planning_.leave_out(asked.robot);
    if (planning_.moves(asked.robot) && !assignments_.contains(asked.robot)) to_make_way_.push_back(asked.robot);
  }
}

void Dispatcher::begin_plan(Now now) {
  std::vector<PlanRequest> requests;
  double footprint_m = 0.0;
  for (const auto& [robot, known] : fleet_.robots()) {
    if (known.description) footprint_m = std::max(footprint_m, known.description->footprint_radius_m);
  }
  // Adds robots that hold nothing, as they were cleared away, and have a goal all the same.
  std::set<RobotId> robots;
  for (const RobotId& robot : traffic_.holding()) robots.insert(robot);
  for (const auto& [robot, assignment] : assignments_) {
    if (is_led(assignment)) robots.insert(robot);
  }
  for (const RobotId& robot : robots) requests.push_back(plan_request(robot, now));
  to_make_way_.clear();
  planning_.begin({context_.snapshots.shared_current(), &routes_.rules()}, footprint_m, std::move(requests),
                  now.steady);
}

PlanRequest Dispatcher::plan_request(const RobotId& robot, Now now) const {
  PlanRequest request;
  request.robot = robot;
  const auto found = assignments_.find(robot);
  const bool is_led = found != assignments_.end() && this->is_led(found->second);
  const Route* const route = is_led ? book_.route(found->second.goal) : nullptr;
  if (const storage::PutOccupancy* const held = traffic_.held(robot)) {
    request.held.assign(held->held.places.begin() + held->from, held->held.places.begin() + held->to + 1);
  }
  // A route that nothing of is released yet may begin beside where the robot stands.
  if (route != nullptr && !is_told(robot, *route)) request.held = {route->places.front()};
  const Robot* const known = fleet_.find(robot);
  const bool is_described = known != nullptr && known->description;
  if (is_described) request.drives = {methods_of(*known), known->description->knows_limits};
  const ClosedHops* const closed =
      is_led ? closed_for(*book_.find(found->second.goal), robot) : overlay_.closed(robot);
  if (closed != nullptr) request.drives.closed = *closed;
  request.avoids = avoided_by(robot, now.steady);
  std::optional<Stays> stays = this->stays(robot);
  // Whom a rule keeps from going on is led up to where it does.
  if (stays == Stays::ruled) stays.reset();
  if (is_described && !stays && is_led) {
    lead(request, found->second, now);
    return request;
  }
  request.stays = !is_described || !not_ready(*known).empty();
  request.stands_for_long = request.stays && stays && stays != Stays::idle;
  const bool is_helpless = stays == Stays::silent || stays == Stays::faulted || stays == Stays::lost;
  request.needs_help = request.stands_for_long && is_helpless;
  const auto arrived = arrived_at_.find(robot);
  if (arrived == arrived_at_.end()) return request;
  const double left_s = context_.config.handling_s - seconds(now.steady - arrived->second);
  request.handles = static_cast<std::uint32_t>(std::ceil(std::max(0.0, left_s) / kBerth_s));
  return request;
}

std::set<PlaceId> Dispatcher::avoided_by(const RobotId& robot, SteadyTime now) const {
  std::set<PlaceId> places;
  const auto found = avoids_.find(robot);
  if (found == avoids_.end()) return places;
  for (const auto& [place, until] : found->second) {
    if (now < until) places.insert(place);
  }
  return places;
}

/// Returns where the robot is led; none: nowhere, or it makes way, and can be asked on.
std::optional<PlaceId> Dispatcher::led_to(const RobotId& robot) const {
  const auto found = assignments_.find(robot);
  if (found == assignments_.end() || !is_led(found->second)) return std::nullopt;
  if (book_.find(found->second.goal)->kind == GoalKind::yield) return std::nullopt;
  return book_.route(found->second.goal)->places.back();
}

/// Says where the robot is going. Who makes way goes nowhere: it can be asked on.
void Dispatcher::lead(PlanRequest& request, const RouteAssignment& assignment, Now now) const {
  const Goal& goal = *book_.find(assignment.goal);
  const Route& route = *book_.route(assignment.goal);
  const bool told = is_told(request.robot, route);
  // Whom a rule keeps where it stands can be asked to make way until the rule lets it on.
  const bool is_kept = !assignment.ruled_by.empty() && assignment.stands_at_end;
  if (goal.kind == GoalKind::yield || is_kept) return;
  request.goal = route.places.back();
  request.ahead.assign(route.places.begin() + (told ? route.released : 0), route.places.end());
  request.priority = goal.priority;
  request.waits_s = seconds(now.steady - assignment.given_at);
}

/// Gives an idle robot a way out of others' way, as far as that can be had.
void Dispatcher::ask_to_make_way(const RobotId& robot, Now now) {
  if (assignments_.contains(robot)) return;
  const PlanRequest request = plan_request(robot, now);
  if (request.stays || request.handles > 0 || request.held.empty()) return;
  const std::optional<std::uint32_t> number = planning_.number(robot, request.held.back());
  if (!number) return;
  const Planning::Piece piece = planning_.piece(*number, request.held);
  if (piece.stops.empty()) return;
  Route here;
  here.id = new_route_id();
  here.robot = robot;
  here.places = {request.held.back()};
  here.version = 0;
  std::optional<Route> route = led_by(context_.snapshots.current(), here, false, piece.places, {});
  if (!route) return;
  Traffic::Stops stops;
  for (const std::uint32_t stop : piece.stops) stops.push_back(stop + 1);
  Piece way{.route = *route, .stops = stops, .way = traffic_.way(*route, 0, &stops), .reach = {}};
  end_by_rules(robot, 0, false, way);
  const std::uint32_t through = way.way.through.value_or(0);
  if (through == 0) return;
  begin_yield(*std::move(route), through, now);
  if (!assignments_.contains(robot)) return;
  const auto stop = std::find(stops.begin(), stops.end(), through);
  const std::size_t given = stop == stops.end() ? 0 : static_cast<std::size_t>(stop - stops.begin()) + 1;
  planning_.released(robot, given, book_.route(assignments_.at(robot).goal)->places.back());
}

/// Stores a yield with all of its route released.
void Dispatcher::begin_yield(Route route, std::uint32_t through, Now now) {
  route.places.resize(through + std::size_t{1});
  route.relations.resize(through);
  route.released = through;
  route.limits = limits_of(routes_.rules(), route.places);
  Goal goal = own_goal(GoalKind::yield, route.robot, route.places.back());
  goal.label = "make-way";
  route.goal = goal.id;
  const GoalId id = goal.id;
  const RobotId robot = route.robot;
  const std::vector<storage::PutOccupancy> claims = traffic_.claim(route, 0, through);
  storage::Transaction transaction;
  for (const storage::PutOccupancy& claim : claims) transaction.changes.emplace_back(claim);
  const GoalBook::Step step = {.state = GoalState::assigned,
                               .cause = fleet_.name_of(robot) + " makes way: it goes to " + to_string(goal.to),
                               .who = "traffic",
                               .kind = "traffic.makes_way"};
  // Tried again with the next plan.
  if (!book_.write(std::move(goal), step, route, std::move(transaction), now)) return;
  traffic_.committed(claims);
  RouteAssignment assignment;
  assignment.goal = id;
  assignment.given_at = now.steady;
  assignment.plan_at = now.steady;
  assignment.waits_since = now;
  send_order(robot, assignments_[robot] = assignment, now.steady);
}

}  // namespace weft::server
