#include "server/traffic/plan/planner.hpp"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>

namespace weft::server {
namespace {

/// Bounds, in berths along its way, how far ahead the place lies that leads a robot, when that is not its goal.
constexpr std::size_t kGuideAhead = 120;
/// Bounds how near a robot may come to it before it gets another one: a plan looks some 40 m ahead.
constexpr double kGuideNear_m = 75.0;
constexpr std::size_t kDistancesKept = 512;
/// Bounds how many berths a robot holds ahead of it while others move: an order may take seconds to come, and who
/// holds more is in the way of who is given a goal meanwhile. The more where nobody is planned to come by. Set with
/// traffic_bench on its own map, seed 1001.
constexpr std::uint32_t kBerthsAhead = 4;
constexpr std::uint32_t kBerthsAheadAlone = 8;

}  // namespace

bool Planner::plan(const RuledNetwork& network, double footprint_m, const std::vector<PlanRequest>& requests,
                   bool may_lag) {
  const bool is_latest = begin(network, footprint_m, requests, may_lag);
  work(std::numeric_limits<std::uint64_t>::max());
  return is_latest;
}

bool Planner::begin(const RuledNetwork& network, double footprint_m, std::vector<PlanRequest> requests,
                    bool may_lag) {
  order_ = {};
  released_.reset();
  making_.reset();
  berths_.see(network.network);
  const bool is_laid = this->is_laid(*network.network, requests);
  const bool lags = (may_lag || !is_laid) && berths_.is_for(footprint_m) && knows(requests);
  if (!lags && !is_laid) return plan_nothing(requests.size());
  Making::Part part = Making::Part::number;
  if (!lags && berths_.begin_to_follow(network, footprint_m)) {
    part = Making::Part::cut;
    distances_.clear();
    pockets_.clear();
    lanes_.clear();
    stood_.clear();
  }
  making_.emplace(std::move(requests), part);
  return !lags;
}

/// Leaves everybody where it is.
bool Planner::plan_nothing(std::size_t robots) {
  MovePlan nothing;
  nothing.moves.resize(robots);
  nothing.kept_by.resize(robots);
  order_ = PlanOrder(std::move(nothing));
  released_.emplace(berths_, lanes_);
  for (std::size_t robot = 0; robot < robots; ++robot) released_->add({});
  methods_.assign(robots, 0);
  makes_way_.assign(robots, std::nullopt);
  led_moves_.assign(robots, 0);
  cut_off_by_.assign(robots, kNobody);
  moving_ = 0;
  return false;
}

/// Returns whether it is known where all lie that the requests name.
bool Planner::is_laid(const Snapshot& network, const std::vector<PlanRequest>& requests) const {
  return std::all_of(requests.begin(), requests.end(), [&](const PlanRequest& request) {
    return (request.held.empty() || berths_.is_laid(network, request.held.back())) &&
           (!request.goal || berths_.is_laid(network, *request.goal));
  });
}

/// Returns whether all places that the requests name are in the map as it is followed.
bool Planner::knows(const std::vector<PlanRequest>& requests) const {
  const auto has = [this](const PlaceId& place) { return berths_.has(place); };
  return std::all_of(requests.begin(), requests.end(), [&](const PlanRequest& request) {
    return std::all_of(request.held.begin(), request.held.end(), has) &&
           std::all_of(request.ahead.begin(), request.ahead.end(), has) && (!request.goal || has(*request.goal));
  });
}

/// Notes which berths are occupied for long. Distances are searched anew when that changes.
void Planner::occupy(const std::vector<PlanRequest>& requests) {
  std::set<Berth> occupied;
  lost_.clear();
  for (std::uint32_t robot = 0; robot < requests.size(); ++robot) {
    const PlanRequest& request = requests[robot];
    if (!request.stands_for_long || request.held.empty() || !berths_.has(request.held.back())) continue;
    const auto occupy = [&](Berth berth) {
      occupied.insert(berth);
      if (request.needs_help) lost_.emplace(berth, robot);
    };
    // It may be anywhere in what it holds.
    for (const Berth berth : held_by(request)) {
      occupy(berth);
      for (const Berth beside : berths_.beside(berth)) occupy(beside);
    }
  }
  if (std::equal(occupied.begin(), occupied.end(), occupied_.begin(), occupied_.end())) return;
  distances_.clear();
  occupied_.assign(occupied.begin(), occupied.end());
}

/// Returns the berths in what the robot holds, in order, and where that ends. Of one that stays also where it begins,
/// between two berths, as it may be there for good; who drives has left that in a moment.
std::vector<Berth> Planner::held_by(const PlanRequest& request) {
  std::vector<Berth> berths;
  for (const PlaceId& place : request.held) {
    const bool is_end = &place == &request.held.back() || (request.stays && &place == &request.held.front());
    if (berths_.has(place) && (is_end || berths_.is_cut(place))) berths.push_back(berths_.at(place));
  }
  return berths;
}

PlanRobot Planner::robot_of(const PlanRequest& request) {
  PlanRobot robot;
  if (request.held.empty() || !berths_.has(request.held.back())) return robot;
  robot.at = berths_.at(request.held.back());
  robot.behind = held_by(request);
  robot.behind.pop_back();
  robot.methods = berths_.methods(request.drives);
  robot.stays = request.stays;
  for (const PlaceId& place : request.avoids) {
    if (berths_.has(place) && berths_.is_cut(place)) robot.avoids.push_back(berths_.at(place));
  }
  robot.handles = request.handles;
  robot.priority = request.priority;
  robot.waits_s = request.waits_s;
  pockets_.look(robot.at, robot.methods);
  if (!request.goal || !berths_.has(*request.goal)) return robot;
  const PlaceId led_to = guide(request, robot.methods);
  robot.goal = &distances(led_to, robot.methods);
  robot.is_goal_at_hand = led_to == *request.goal;
  robot.pocket = pockets_.look(berths_.at(*request.goal), robot.methods);
  return robot;
}

/// Returns who cuts the robot off from its goal, that is, it comes there only when a person has helped that one;
/// kNobody: nobody does. It waits for that as near as it comes, so that it goes on at once; where it keeps others
/// there it is planned as one without a goal.
std::uint32_t Planner::cut_off_by(const PlanRequest& request, const PlanRobot& robot) {
  const auto is_lost = [&](const PlaceId& place) {
    // To number a place that is no berth yet would change arcs.
    const bool is_berth = berths_.has(place) && (berths_.is_cut(place) || place == *request.goal);
    return is_berth && lost_.contains(berths_.at(place));
  };
  // Its way leads round them where it can: only who has one of them ahead is worth a search from its goal.
  if (!is_lost(*request.goal) && std::none_of(request.ahead.begin(), request.ahead.end(), is_lost)) return kNobody;
  Distances& goal = distances(*request.goal, robot.methods);
  const auto lost = lost_.find(goal.leads_over([this](Berth berth) { return lost_.contains(berth); }, robot.at));
  return lost == lost_.end() ? kNobody : lost->second;
}

/// Returns the place that leads the robot: its goal when that is near enough, else a berth on its way there. It stays
/// the same until the robot comes near, so that distances to it are searched once.
PlaceId Planner::guide(const PlanRequest& request, std::uint32_t methods) {
  const std::vector<PlaceId>& ahead = request.ahead;
  PlaceId& led_to = guides_[request.robot];
  if (led_to == *request.goal) return led_to;
  const bool is_ahead = std::find(ahead.begin(), ahead.end(), led_to) != ahead.end();
  if (is_ahead && distances(led_to, methods).from_m(berths_.at(request.held.back())) > kGuideNear_m) return led_to;
  led_to = *request.goal;
  std::size_t cuts = 0;
  for (const PlaceId& place : ahead) {
    if (!berths_.is_cut(place)) continue;
    if (++cuts == kGuideAhead) led_to = place;
  }
  if (cuts < 2 * kGuideAhead) led_to = *request.goal;
  return led_to;
}

Distances& Planner::distances(const PlaceId& to, std::uint32_t methods) {
  const Key key{to, methods};
  used_.insert(key);
  std::unique_ptr<Distances>& known = distances_[key];
  if (known == nullptr) known = std::make_unique<Distances>(berths_, berths_.at(to), methods, occupied_);
  return *known;
}

std::uint32_t Planner::berths_in(const std::vector<PlaceId>& held) const {
  return static_cast<std::uint32_t>(
      std::count_if(held.begin(), held.end() - 1, [this](const PlaceId& place) { return berths_.is_cut(place); }));
}

std::uint32_t Planner::may(std::uint32_t robot, std::uint32_t held) {
  const std::uint32_t turn = order_.may(robot);
  const Berth at = released_->at(robot);
  std::uint32_t move = order_.released(robot);
  for (; move < turn; ++move, ++held) {
    const bool is_far = held >= kBerthsAheadAlone || (held >= kBerthsAhead && order_.is_shared(robot, move));
    const Berth to = order_.moves(robot)[move].arc->to;
    if ((moving_ > 1 && is_far) || (!is_led(robot, move) && !released_->kept_by(robot, to).empty())) break;
    released_->put(robot, to);
  }
  released_->put(robot, at);
  return makes_way_[robot] && !is_led(robot, order_.released(robot)) ? without_return(robot, move) : move;
}

/// Returns how many of the moves lead a robot that makes way on: to where it stood before, and was in the way, it
/// does not go unless it gets away from there.
std::uint32_t Planner::without_return(std::uint32_t robot, std::uint32_t moves) {
  const std::uint32_t first = order_.released(robot);
  const Berth at = released_->at(robot);
  const std::span planned = order_.moves(robot);
  if (leads_away(berths_, at, planned.subspan(first, moves - first))) return moves;
  std::set<Berth> stood = {at};
  if (const auto known = stood_.find(*makes_way_[robot]); known != stood_.end())
    stood.insert(known->second.begin(), known->second.end());
  std::uint32_t move = first;
  while (move < moves && stood.insert(planned[move].arc->to).second) ++move;
  return move;
}

std::vector<std::uint32_t> Planner::waits_for(std::uint32_t robot) {
  const std::uint32_t move = order_.released(robot);
  if (order_.may(robot) == move) {
    const std::vector<std::uint32_t> others = order_.waits_for(robot);
    const bool is_cut_off = others.empty() && cut_off_by_[robot] != kNobody;
    return is_cut_off ? std::vector{cut_off_by_[robot]} : others;
  }
  if (is_led(robot, move)) return {};
  std::vector<std::uint32_t> robots = released_->kept_by(robot, order_.moves(robot)[move].arc->to);
  std::erase(robots, robot);
  return robots;
}

bool Planner::is_safe(std::uint32_t robot, const std::vector<PlaceId>& ahead) {
  if (released_->at(robot) == kNoBerth) return true;
  const auto next = std::find_if(ahead.begin(), ahead.end(), [this](const PlaceId& place) {
    return berths_.has(place) && berths_.is_cut(place);
  });
  return next == ahead.end() || released_->kept_by(robot, berths_.at(*next)).empty();
}

void Planner::release(std::uint32_t robot, std::uint32_t moves) {
  if (makes_way_[robot]) note_stood(robot, moves);
  order_.release(robot, moves);
  if (moves > 0) released_->put(robot, order_.moves(robot)[moves - 1].arc->to);
}

/// Remembers where a robot that makes way stood, until it gets away from there.
void Planner::note_stood(std::uint32_t robot, std::uint32_t moves) {
  const std::uint32_t first = order_.released(robot);
  if (moves <= first) return;
  const Berth at = released_->at(robot);
  const auto made = std::span(order_.moves(robot)).subspan(first, moves - first);
  std::vector<Berth>& stood = stood_[*makes_way_[robot]];
  if (leads_away(berths_, at, made))
    stood.clear();
  else
    stood.push_back(at);
}

PlannedWay Planner::way(std::uint32_t robot, std::uint32_t first, std::uint32_t last) const {
  PlannedWay planned;
  for (std::uint32_t number = first; number < last; ++number) {
    const PlannedMove& move = order_.moves(robot)[number];
    const std::vector<PlaceId>& way = berths_.way(move.from, *move.arc, methods_[robot]);
    planned.places.insert(planned.places.end(), way.begin(), way.end());
    planned.stops.push_back(static_cast<std::uint32_t>(planned.places.size() - 1));
  }
  return planned;
}

void Planner::forget_unused() {
  if (distances_.size() > kDistancesKept) {
    std::erase_if(distances_, [this](const auto& known) { return !used_.contains(known.first); });
  }
  used_.clear();
}

}  // namespace weft::server
