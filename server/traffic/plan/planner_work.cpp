#include <algorithm>
#include <utility>

#include "server/traffic/plan/gridlock.hpp"
#include "server/traffic/plan/planner.hpp"

/// Makes a plan a piece at a time.
namespace weft::server {
namespace {

// These bound what is done at once, and say what it counts, in the unit of `MoveSteps`.
constexpr std::size_t kPlacesCutAtOnce = 256;
constexpr std::uint64_t kWorkToCut = 16;
constexpr std::size_t kBerthsSearchedAtOnce = 16;
constexpr std::uint64_t kWorkToSearch = 2;
constexpr std::uint64_t kWorkToDescribe = 16;

}  // namespace

void Planner::work(std::uint64_t most) {
  const std::uint64_t begin = done();
  while (making_ && done() - begin < most) go_on(most - (done() - begin));
}

/// Does the least that can be done at once, or moves of the robots, `most` of these.
void Planner::go_on(std::uint64_t most) {
  ++done_;
  switch (making_->part) {
    case Making::Part::cut:
      return cut_more();
    case Making::Part::number:
      return number_next();
    case Making::Part::describe:
      return describe_next();
    case Making::Part::cut_off:
      return cut_off_next();
    case Making::Part::move:
      return move_on(most);
  }
}

void Planner::cut_more() {
  done_ += kWorkToCut;
  if (berths_.cut(kPlacesCutAtOnce)) making_->part = Making::Part::number;
}

/// Numbers where the next robot stands and wants to go. All places are numbered before anything is planned: berths
/// that come make others forget their arcs.
void Planner::number_next() {
  if (making_->next < making_->requests.size()) {
    const PlanRequest& request = making_->requests[making_->next++];
    if (!request.held.empty() && berths_.has(request.held.back())) berths_.at(request.held.back());
    if (request.goal && berths_.has(*request.goal)) berths_.at(*request.goal);
    return;
  }
  occupy(making_->requests);
  making_->robots.reserve(making_->requests.size());
  methods_.clear();
  making_->next = 0;
  making_->part = Making::Part::describe;
}

/// Describes the next robot once all is looked up for that.
void Planner::describe_next() {
  if (making_->next < making_->requests.size()) {
    const PlanRequest& request = making_->requests[making_->next];
    done_ += kWorkToSearch;
    if (!has_searched(request)) return;
    done_ += kWorkToDescribe;
    making_->robots.push_back(robot_of(request));
    methods_.push_back(making_->robots.back().methods);
    ++making_->next;
    return;
  }
  moving_ =
      static_cast<std::uint32_t>(std::count_if(making_->requests.begin(), making_->requests.end(),
                                               [](const PlanRequest& request) { return request.goal.has_value(); }));
  cut_off_by_.assign(making_->requests.size(), kNobody);
  making_->next = 0;
  making_->part = Making::Part::cut_off;
}

/// Searches a little farther what describing the robot takes. Returns whether that is all known.
bool Planner::has_searched(const PlanRequest& request) {
  if (request.held.empty() || !berths_.has(request.held.back())) return true;
  const Berth at = berths_.at(request.held.back());
  const std::uint32_t methods = berths_.methods(request.drives);
  if (!pockets_.look_around(at, methods, kBerthsSearchedAtOnce)) return false;
  pockets_.look(at, methods);
  if (!request.goal || !berths_.has(*request.goal)) return true;
  const auto guided = guides_.find(request.robot);
  const bool is_guided = guided != guides_.end() && guided->second != *request.goal &&
                         std::find(request.ahead.begin(), request.ahead.end(), guided->second) != request.ahead.end();
  if (is_guided && !distances(guided->second, methods).search(at, kBerthsSearchedAtOnce)) return false;
  if (!distances(guide(request, methods), methods).search(at, kBerthsSearchedAtOnce)) return false;
  return pockets_.look_around(berths_.at(*request.goal), methods, kBerthsSearchedAtOnce);
}

void Planner::cut_off_next() {
  const std::size_t next = lost_.empty() ? making_->requests.size() : making_->next++;
  if (next < making_->requests.size()) {
    const PlanRobot& robot = making_->robots[next];
    if (robot.goal != nullptr) cut_off_by_[next] = cut_off_by(making_->requests[next], robot);
    return;
  }
  send_on_as_before();
  lead_on_as_before();
  making_->steps.emplace(berths_, pockets_, lanes_, making_->robots, rules_);
  making_->part = Making::Part::move;
}

/// Has robots make way that the plan before found to keep others, where these still have to come by.
void Planner::send_on_as_before() {
  if (sent_on_.empty()) return;
  std::map<RobotId, std::uint32_t> numbers;
  for (const PlanRequest& request : making_->requests) {
    numbers.emplace(request.robot, static_cast<std::uint32_t>(numbers.size()));
  }
  for (std::uint32_t robot = 0; robot < making_->robots.size(); ++robot) {
    const auto sent = sent_on_.find(making_->requests[robot].robot);
    if (sent == sent_on_.end() || making_->requests[robot].goal) continue;
    const auto& [kept, to] = sent->second;
    const auto number = numbers.find(kept);
    if (number == numbers.end() || making_->robots[number->second].goal == nullptr) continue;
    const bool is_berth = berths_.has(to) && (berths_.is_cut(to) || to == making_->requests[number->second].goal);
    if (!is_berth) continue;
    const PlanRobot& other = making_->robots[number->second];
    const Meeting meeting{number->second, berths_.at(to)};
    if (other.goal->from_m(meeting.to) < other.goal->from_m(other.at)) making_->robots[robot].sent_on = meeting;
  }
}

/// Remembers whom robots without a goal keep, for the next plan.
void Planner::note_sent_on(const MovePlan& plan) {
  sent_on_.clear();
  for (std::size_t robot = 0; robot < plan.sent_on.size(); ++robot) {
    const std::optional<Meeting>& meeting = plan.sent_on[robot];
    if (!meeting || making_->requests[robot].goal) continue;
    sent_on_[making_->requests[robot].robot] = {making_->requests[meeting->robot].robot, berths_.place(meeting->to)};
  }
}

void Planner::move_on(std::uint64_t most) {
  // Work in lanes is counted by the steps and by the planner, all other work by the steps alone.
  const std::uint64_t before = making_->steps->done();
  const std::uint64_t counted = done();
  const bool is_complete = making_->steps->work(most);
  done_ += (making_->steps->done() - before) - (done() - counted);
  if (!is_complete) return;
  MovePlan plan = making_->steps->take();
  making_->steps.reset();
  if (!plans_anew(plan)) return end_with(std::move(plan));
  making_->steps.emplace(berths_, pockets_, lanes_, making_->robots, rules_);
}

/// Returns whether the moves are to be planned once more, for robots that are described otherwise.
bool Planner::plans_anew(const MovePlan& plan) {
  std::vector<PlanRobot>& robots = making_->robots;
  const Making::Round round = making_->round;
  if (round == Making::Round::all) {
    making_->round = Making::Round::without_cut_off;
    std::vector<bool> are_cut_off;
    for (const std::uint32_t by : cut_off_by_) are_cut_off.push_back(by != kNobody);
    if (keep_others(plan, robots, are_cut_off)) {
      for (std::size_t robot = 0; robot < robots.size(); ++robot) {
        if (!are_cut_off[robot]) continue;
        robots[robot].goal = nullptr;
        robots[robot].pocket = Pockets::kNone;
      }
      return true;
    }
  }
  if (round == Making::Round::led_away) return false;
  const bool is_last = round == Making::Round::giving_way;
  const std::vector<bool> locked = gridlocked(plan, robots);
  if (std::ranges::find(locked, true) == locked.end()) return false;
  if (round == Making::Round::gridlocked) {
    making_->round = Making::Round::led_away;
    return leads_away_one(plan, locked);
  }
  making_->round = is_last ? Making::Round::gridlocked : Making::Round::giving_way;
  for (std::size_t robot = 0; robot < robots.size(); ++robot) {
    if (!locked[robot]) continue;
    robots[robot].gives_way = true;
    robots[robot].is_gridlocked = is_last;
  }
  return true;
}

/// Returns where robots stand; who stays may be anywhere in what it holds.
SafeStates Planner::standing(const std::vector<PlanRobot>& robots) {
  SafeStates states(berths_, lanes_);
  for (const PlanRobot& robot : robots) states.add({robot.at, robot.methods});
  for (const PlanRobot& robot : robots) {
    if (!robot.stays) continue;
    for (const Berth berth : robot.behind) states.add({berth, robot.methods});
  }
  return states;
}

/// Leads one of the gridlocked robots away, as `led_away_of`. Returns whether there is one.
bool Planner::leads_away_one(const MovePlan& plan, const std::vector<bool>& locked) {
  SafeStates states = standing(making_->robots);
  LedAway led = led_away_of(states, plan, making_->robots, locked,
                            [this](std::uint32_t robot) { return led_.led_at(making_->requests[robot].robot); });
  done_ += states.searches();
  if (led.robot == kNobody) return false;
  std::vector<PlaceId> over;
  for (const Berth berth : led.over) over.push_back(berths_.place(berth));
  led_.lead(making_->requests[led.robot].robot, std::move(over));
  making_->robots[led.robot].led_over = std::move(led.over);
  return true;
}

/// Leads robots on that a plan before led away, where nobody has come into their way.
void Planner::lead_on_as_before() {
  SafeStates states = standing(making_->robots);
  const auto is_berth = [this](const PlaceId& place) { return berths_.has(place) && berths_.is_cut(place); };
  for (std::uint32_t robot = 0; robot < making_->robots.size(); ++robot) {
    PlanRobot& known = making_->robots[robot];
    const PlanRequest& request = making_->requests[robot];
    if (known.at == kNoBerth) continue;
    const std::vector<PlaceId> over = led_.led_on(request.robot, request.held.back(), !known.behind.empty());
    if (over.empty()) continue;
    std::vector<Berth> berths;
    if (!known.stays && std::ranges::all_of(over, is_berth)) {
      for (const PlaceId& place : over) berths.push_back(berths_.at(place));
    }
    if (!berths.empty() && states.is_way_out(robot, berths)) {
      known.led_over = std::move(berths);
    } else {
      led_.end(request.robot);
    }
  }
  done_ += states.searches();
}

void Planner::end_with(MovePlan plan) {
  pushes_ += plan.pushes;
  asked_several_ += plan.asked_several;
  note_sent_on(plan);
  moving_ += plan.to_make_way;
  order_ = PlanOrder(std::move(plan));
  released_.emplace(berths_, lanes_);
  for (const PlanRobot& robot : making_->robots) released_->add({robot.at, robot.methods}, robot.is_gridlocked);
  makes_way_.clear();
  led_moves_.clear();
  for (const PlanRobot& robot : making_->robots)
    led_moves_.push_back(static_cast<std::uint32_t>(robot.led_over.size()));
  std::map<RobotId, std::vector<Berth>> stood;
  for (const PlanRequest& request : making_->requests) {
    makes_way_.push_back(request.goal ? std::nullopt : std::optional(request.robot));
    const auto known = stood_.find(request.robot);
    if (!request.goal && known != stood_.end()) stood.insert(std::move(*known));
  }
  stood_ = std::move(stood);
  led_.forget_unless([this](const RobotId& robot) {
    return std::ranges::find(making_->requests, robot, &PlanRequest::robot) != making_->requests.end();
  });
  forget_unused();
  making_.reset();
}

}  // namespace weft::server
