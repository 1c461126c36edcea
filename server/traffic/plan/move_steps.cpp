#include "server/traffic/plan/move_steps.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

/// Takes the steps of a plan in their order.
namespace weft::server {
namespace {
/// Is how many robots are looked at for as much as one decides.
constexpr std::size_t kLooksOfDecision = 4;
}  // namespace

MoveSteps::MoveSteps(BerthGraph& graph, Pockets& pockets, Lanes& lanes, const std::vector<PlanRobot>& robots,
                     const PlanRules& rules)
    : graph_(graph),
      pockets_(pockets),
      lanes_(lanes),
      turns_(pockets),
      meetings_(graph, lanes),
      safe_(graph, lanes),
      rules_(rules),
      states_(robots.size()),
      order_(robots.size()) {
  plan_.moves.resize(robots.size());
  for (std::uint32_t i = 0; i < robots.size(); ++i) {
    states_[i].robot = robots[i];
    meetings_.add(robots[i].at, robots[i].methods);
    safe_.add({robots[i].at, robots[i].methods}, robots[i].is_gridlocked);
    states_[i].handles = robots[i].handles;
    states_[i].sent_on = robots[i].sent_on;
    states_[i].drives = static_cast<std::uint32_t>(robots[i].behind.size());
    if (robots[i].at == kNoBerth) continue;
    if (is_at_goal(i)) arrive(i, states_[i].drives + rules_.handling);
    occupied_.stand(robots[i].at, i);
    // One that stays may be anywhere in what it holds.
    for (const Berth berth : robots[i].behind) {
      robots[i].stays ? occupied_.stand(berth, i) : occupied_.drive_through(berth, i);
    }
  }
  std::iota(order_.begin(), order_.end(), 0U);
}

bool MoveSteps::work(std::uint64_t most) {
  const std::uint64_t begin = done();
  while (step_ < rules_.steps) {
    go_on();
    if (done() - begin >= most) break;
  }
  return step_ >= rules_.steps;
}

MovePlan MoveSteps::take() {
  for (RobotInStep& state : states_) {
    plan_.kept_by.push_back(std::move(state.kept_by));
    plan_.sent_on.push_back(state.sent_on);
    if (state.has_way_out) ++plan_.to_make_way;
  }
  return std::move(plan_);
}

std::uint64_t MoveSteps::done() const {
  return decisions_ + safe_.searches() + lanes_.searches() + graph_.looked_up();
}

/// Does the least that can be done at once.
void MoveSteps::go_on() {
  ++decisions_;
  switch (part_) {
    case Part::begin:
      return begin_step();
    case Part::decide:
      return next_ < order_.size() ? decide() : begin_to_check();
    case Part::check:
      return next_ < moving_.size() ? check() : move_all();
  }
}

void MoveSteps::begin_step() {
  look_at_pockets();
  meetings_.begin_step();
  std::stable_sort(order_.begin(), order_.end(),
                   [this](std::uint32_t a, std::uint32_t b) { return goes_before(a, b); });
  decisions_ += states_.size() / kLooksOfDecision;
  part_ = Part::decide;
  next_ = 0;
}

bool MoveSteps::goes_before(std::uint32_t a, std::uint32_t b) const {
  const PlanRobot& first = states_[a].robot;
  const PlanRobot& second = states_[b].robot;
  if (is_led(a) != is_led(b)) return is_led(a);
  if (states_[a].leaves != states_[b].leaves) return states_[a].leaves;
  if (is_sent_first(a) != is_sent_first(b)) return is_sent_first(a);
  if ((first.goal == nullptr) != (second.goal == nullptr)) return first.goal != nullptr;
  if (first.priority != second.priority) return first.priority > second.priority;
  return first.waits_s != second.waits_s ? first.waits_s > second.waits_s : a < b;
}

/// Has the next robot decide, and with it whom it asks.
void MoveSteps::decide() {
  const std::uint32_t robot = order_[next_++];
  if (!is_there(robot) || states_[robot].has_wish) return;
  const std::size_t decided = decided_.size();
  wish(robot, kNobody);
  decisions_ += decided_.size() - decided;
  if (states_[robot].wish == nullptr) forget_asked(decided + 1);
}

/// Finds who can move in this step as far as room goes.
void MoveSteps::begin_to_check() {
  // Moves asked robots before those that were looked at later, whatever their priority.
  moving_.clear();
  for (const std::uint32_t robot : std::exchange(decided_, {})) {
    const BerthArc* const arc = states_[robot].wish;
    if (arc == nullptr) continue;
    if (const std::uint32_t other = occupied_.occupant(*arc, robot); other != kNobody) {
      note_kept(robot, other);
      continue;
    }
    if (!occupied_.keeps_off_movers(*arc, step_)) continue;
    moving_.push_back(robot);
    occupied_.move(*arc, step_);
  }
  for (const std::uint32_t robot : order_) forget_wish(robot);
  decisions_ += states_.size() / kLooksOfDecision;
  part_ = Part::check;
  next_ = 0;
}

/// Takes the next robot out of those that move if somebody would be stuck by that.
void MoveSteps::check() {
  const std::uint32_t robot = moving_[next_];
  if (is_safe(robot)) {
    ++next_;
  } else {
    moving_.erase(moving_.begin() + static_cast<std::ptrdiff_t>(next_));
  }
}

void MoveSteps::move_all() {
  // Nobody enters a lane in the step in which another one leaves it, so all of these find the same.
  for (const std::uint32_t robot : moving_) states_[robot].first = meetings_.first(robot, states_[robot].wish->to);
  for (const std::uint32_t robot : moving_) move(robot, step_);
  for (std::uint32_t robot = 0; robot < states_.size(); ++robot) get_on(robot);
  decisions_ += states_.size() / kLooksOfDecision;
  part_ = Part::begin;
  ++step_;
}

/// Forgets the decisions to stay of those that were asked in vain: each may move yet for a reason of its own.
void MoveSteps::forget_asked(std::size_t first) {
  const auto asked = decided_.begin() + static_cast<std::ptrdiff_t>(first);
  decided_.erase(std::remove_if(asked, decided_.end(),
                                [this](std::uint32_t robot) {
                                  const bool stays = states_[robot].wish == nullptr;
                                  if (stays) forget_wish(robot);
                                  return stays;
                                }),
                 decided_.end());
}

/// Returns whether the robot goes before those that have goals: it is to make way, they are gridlocked with it, and
/// so may have to make way for it first.
bool MoveSteps::is_sent_first(std::uint32_t robot) const {
  const RobotInStep& state = states_[robot];
  return state.robot.is_gridlocked && state.robot.goal == nullptr && state.sent_on;
}

/// Returns whether the robot lets the one past first that it keeps: it has nothing else to do, or that one goes
/// before it, was refused in this step, and would wait for ever.
bool MoveSteps::is_sent_on(std::uint32_t robot) const {
  const RobotInStep& state = states_[robot];
  if (!state.sent_on || state.leaves) return false;
  const bool gives_way = state.robot.gives_way && state.sent_in == step_ && goes_before(state.sent_on->robot, robot);
  return state.robot.goal == nullptr || gives_way;
}

/// Returns whether nobody is stuck when the robot moves as it wishes; it is there then. One that is led away is not
/// asked: its way was found free.
bool MoveSteps::is_safe(std::uint32_t robot) {
  std::vector<std::uint32_t> stuck;
  if (!is_led(robot)) stuck = safe_.stuck_by(robot, states_[robot].wish->to, {});
  for (const std::uint32_t other : stuck) {
    if (other != robot) note_kept(robot, other);
  }
  if (stuck.empty()) safe_.put(robot, states_[robot].wish->to);
  return stuck.empty();
}

/// Finds who is in which pocket, and who has to come out.
void MoveSteps::look_at_pockets() {
  turns_.begin_step();
  for (std::uint32_t robot = 0; robot < states_.size(); ++robot) {
    RobotInStep& state = states_[robot];
    state.in = pockets_.of(state.robot.at);
    for (std::size_t i = state.robot.behind.size() - state.drives; i < state.robot.behind.size(); ++i) {
      turns_.is_at(state.robot.behind[i], robot);
    }
    turns_.is_at(state.robot.at, robot);
    turns_.wants(robot, state.robot);
  }
  for (std::uint32_t robot = 0; robot < states_.size(); ++robot) {
    RobotInStep& state = states_[robot];
    state.leaves = state.in != Pockets::kNone && state.handles == 0 &&
                   (state.robot.goal == nullptr ? can_leave_for_others(robot) : state.robot.pocket != state.in);
  }
}

/// Returns whether another one wants to go into the pocket where the robot stands, and is not face to face with it.
bool MoveSteps::can_leave_for_others(std::uint32_t robot) {
  const std::vector<PocketTurns::Wanting>& others = turns_.wanted_by(states_[robot].in);
  return std::any_of(others.begin(), others.end(), [&](const PocketTurns::Wanting& other) {
    return !meetings_.are_face_to_face(robot, other.robot);
  });
}

void MoveSteps::move(std::uint32_t robot, std::uint32_t step) {
  RobotInStep& state = states_[robot];
  const BerthArc* const arc = std::exchange(state.wish, nullptr);
  plan_.moves[robot].push_back({arc, state.robot.at, step, std::exchange(state.first, {})});
  occupied_.leave(state.robot.at);
  state.robot.at = arc->to;
  if (is_led(robot)) ++state.led;
  meetings_.moves(robot, arc->to);
  state.is_kept_known = true;
  occupied_.stand(arc->to, robot);
  if (is_at_goal(robot)) arrive(robot, rules_.handling + 1);
}

bool MoveSteps::is_at_goal(std::uint32_t robot) const {
  const PlanRobot& known = states_[robot].robot;
  return known.goal != nullptr && known.is_goal_at_hand && known.goal->from_m(known.at) == 0.0;
}

void MoveSteps::get_on(std::uint32_t robot) {
  RobotInStep& state = states_[robot];
  state.wish = nullptr;
  if (state.handles > 0) --state.handles;
  if (state.drives == 0 || state.robot.stays) return;
  occupied_.have_driven_through(state.robot.behind[state.robot.behind.size() - state.drives], robot);
  --state.drives;
}

}  // namespace weft::server
