#include <algorithm>
#include <utility>

#include "server/traffic/plan/drive_out.hpp"
#include "server/traffic/plan/move_steps.hpp"

/// Decides what a robot wishes in a step of a plan, and whom it asks to make way for that.
namespace weft::server {

/// Decides where the robot wants to go next; `asker` wants it away from where it stands. Returns whether it will
/// go.
bool MoveSteps::wish(std::uint32_t robot, std::uint32_t asker) {
  RobotInStep& state = states_[robot];
  state.has_wish = true;
  state.is_asking = true;
  decided_.push_back(robot);
  const bool can_move = !state.robot.stays && state.handles == 0;
  const bool goes = can_move && choose(robot, asker);
  if (!goes) stay(robot);
  state.is_asking = false;
  return goes || (asker == kNobody);
}

bool MoveSteps::choose(std::uint32_t robot, std::uint32_t asker) {
  RobotInStep& state = states_[robot];
  state.met.clear();
  if (is_led(robot)) return is_led_on(robot);
  if (asker != kNobody) return goes(robot, asker);
  if (turns_.is_refused(robot, state.robot)) {
    return clears(robot, [&](const PlanRobot& there) { return !turns_.is_refused(robot, there); });
  }
  if (turns_.is_in_a_mouth(state.robot)) {
    ++plan_.pushes;
    return clears(robot, [&](const PlanRobot& there) { return !turns_.is_in_a_mouth(there); });
  }
  if (is_sent_on(robot)) {
    const Meeting other = *state.sent_on;
    const auto is_out = [&](const PlanRobot& there) { return !would_keep_from(robot, there, other); };
    const bool has_goal = state.robot.goal != nullptr;
    const bool is_first = step_ == 0 && !has_goal;
    const bool can_now = !meetings_.are_face_to_face(robot, other.robot);
    const bool is_in_the_way = (can_now || is_first) && !is_out(state.robot);
    if (is_first) state.has_way_out = is_in_the_way && way_out(robot, is_out) != nullptr;
    if (is_in_the_way && can_now) {
      ++plan_.pushes;
      const bool is_cleared = clears(robot, is_out);
      if (is_cleared || !has_goal) return is_cleared;
      state.met.clear();
    }
  }
  if (goes(robot, kNobody)) return true;
  std::vector<std::uint32_t> kept_in;
  for (const std::uint32_t other : state.met) {
    if (meetings_.shuts_in(robot, other)) kept_in.push_back(other);
  }
  if (kept_in.empty()) return false;
  ++plan_.pushes;
  return clears(robot, [&](const PlanRobot& there) {
    return std::all_of(kept_in.begin(), kept_in.end(),
                       [&](std::uint32_t other) { return meetings_.is_aside(robot, there.at, other); });
  });
}

/// Returns whether the robot keeps the other one, from there, from going where it would: they meet, or the robot
/// would be stuck when that one went there.
bool MoveSteps::would_keep_from(std::uint32_t robot, const PlanRobot& there, const Meeting& other) {
  if (meetings_.would_keep_from({there.at, there.methods}, other)) return true;
  if (!safe_.concern(other.robot, other.to, {there.at, there.methods})) return false;
  safe_.put(robot, there.at);
  const std::vector<std::uint32_t> stuck = safe_.stuck_by(other.robot, other.to, {});
  safe_.put(robot, states_[robot].robot.at);
  return std::binary_search(stuck.begin(), stuck.end(), robot);
}

/// Returns the first drive of the robot's way to where it is out of others' way, its goal or not, round those that
/// cannot make way; null: there is none.
template <class IsOut>
const BerthArc* MoveSteps::way_out(std::uint32_t robot, IsOut&& is_out) {
  PlanRobot there = states_[robot].robot;
  return drive_out(graph_, {.from = there.at,
                            .methods = there.methods,
                            .is_closed = [&](const BerthArc& arc) { return is_closed(robot, arc); },
                            .is_out =
                                [&](Berth berth) {
                                  there.at = berth;
                                  return is_out(there);
                                }});
}

/// Has the robot drive on to where it is out of others' way.
template <class IsOut>
bool MoveSteps::clears(std::uint32_t robot, IsOut&& is_out) {
  const BerthArc* const first = way_out(robot, is_out);
  return first != nullptr &&
         (set_off(robot, *first, Care::off_all_ways) || set_off(robot, *first, Care::off_where_they_end));
}

/// Returns whether the robot does not get through there: one stands there that does not make way for it.
bool MoveSteps::is_closed(std::uint32_t robot, const BerthArc& arc) {
  const PlanRobot& known = states_[robot].robot;
  if (std::find(known.avoids.begin(), known.avoids.end(), arc.to) != known.avoids.end()) return true;
  if (!turns_.may_go(robot, known, arc.to, false)) return true;
  const std::vector<std::uint32_t>& met = states_[robot].met;
  return std::any_of(arc.touches.begin(), arc.touches.end(), [&](Berth berth) {
    const std::uint32_t other = occupied_.who_stands_at(berth);
    if (other == kNobody || other == robot) return false;
    return states_[other].robot.stays || std::find(met.begin(), met.end(), other) != met.end();
  });
}

/// Has the robot make the next drive of the way on which it is led away.
bool MoveSteps::is_led_on(std::uint32_t robot) {
  const PlanRobot& led = states_[robot].robot;
  const std::vector<BerthArc>& next = graph_.next(led.at, led.methods);
  const auto arc = std::find_if(next.begin(), next.end(),
                                [&](const BerthArc& one) { return one.to == led.led_over[states_[robot].led]; });
  return arc != next.end() && set_off(robot, *arc, Care::off_where_they_end);
}

bool MoveSteps::goes(std::uint32_t robot, std::uint32_t asker) {
  const std::vector<MoveChoice> choices = this->choices(robot, asker);
  const auto takes = [&](Care care) {
    return std::any_of(choices.begin(), choices.end(), [&](const MoveChoice& choice) {
      const bool is_taken = set_off(robot, *choice.arc, care);
      states_[robot].is_kept_known = states_[robot].is_kept_known || !states_[robot].kept_by.empty();
      return is_taken;
    });
  };
  return takes(Care::off_all_ways) || (asker != kNobody && takes(Care::off_where_they_end));
}

/// Returns where the robot would go, the best first; who is asked to make way goes anywhere.
std::vector<MoveChoice> MoveSteps::choices(std::uint32_t robot, std::uint32_t asker) {
  const Berth here = states_[robot].robot.at;
  Distances* goal = states_[robot].robot.goal;
  const bool is_sent_out = goal == nullptr && states_[robot].leaves;
  if (is_sent_out) goal = &pockets_.to_mouth(states_[robot].in, states_[robot].robot.methods);
  Distances* const wanted = asker == kNobody ? nullptr : states_[asker].robot.goal;
  const double here_m = goal == nullptr ? 0.0 : goal->from_m(here);
  std::vector<MoveChoice> choices;
  for (const BerthArc& arc : graph_.next(here, states_[robot].robot.methods)) {
    const double there_m = goal == nullptr ? 0.0 : goal->more_m(arc.to) + goal->from_m(arc.to);
    const bool is_nearer = goal != nullptr && there_m < here_m;
    // From there it would never come to its goal, or it has tried that in vain.
    const std::vector<Berth>& avoids = states_[robot].robot.avoids;
    if (there_m == Distances::kFar_m || std::find(avoids.begin(), avoids.end(), arc.to) != avoids.end()) continue;
    const bool is_a_stop = graph_.is_cut(arc.to) || (goal != nullptr && there_m == 0.0);
    if (!is_a_stop || (!is_nearer && asker == kNobody)) continue;
    if (!turns_.may_go(robot, states_[robot].robot, arc.to, asker != kNobody)) {
      const std::uint32_t keeper = turns_.keeper(robot, states_[robot].robot, arc.to);
      if (is_nearer && keeper != kNobody) note_kept(robot, keeper);
      continue;
    }
    const bool is_unwanted = wanted == nullptr || wanted->from_m(arc.to) > wanted->from_m(here);
    const double cost_m = goal == nullptr || is_sent_out ? there_m : arc.length_m + there_m;
    const bool is_last = asker != kNobody && turns_.leads_in(states_[robot].robot, arc.to);
    choices.push_back({&arc, is_last, is_unwanted, occupied_.occupant(arc, robot) == kNobody, cost_m});
  }
  std::stable_sort(choices.begin(), choices.end(), is_better);
  return choices;
}

/// Takes the arc for the robot's wish if nobody has a wish there, and all who stand there make way.
bool MoveSteps::set_off(std::uint32_t robot, const BerthArc& arc, Care care) {
  if (const std::uint32_t other = hinderer(robot, arc, care); other != kNobody) {
    note_kept(robot, other);
    return false;
  }
  if (!is_led(robot) && would_meet(robot, arc)) return false;
  put_wish(robot, &arc);
  const bool goes_in = turns_.take(arc.to, robot);
  std::uint32_t asked = 0;
  for (const Berth berth : arc.touches) {
    const std::uint32_t other = occupied_.who_stands_at(berth);
    if (other == kNobody || other == robot || states_[other].has_wish || states_[other].drives > 0) continue;
    ++plan_.pushes;
    if (++asked == 2) ++plan_.asked_several;
    if (wish(other, robot)) continue;
    note_met(robot, other, arc.to);
    take_back_wish(robot);
    if (goes_in) turns_.give_back(arc.to);
    return false;
  }
  return true;
}

/// Returns whether the robot would come face to face with another one from there on, or some would be stuck. One
/// that has nothing to do is sent on.
bool MoveSteps::would_meet(std::uint32_t robot, const BerthArc& arc) {
  std::vector<std::uint32_t> met = meetings_.refuse(robot, arc.to);
  if (met.empty()) {
    std::vector<std::uint32_t> leaving;
    for (const Berth berth : arc.touches) {
      if (const std::uint32_t other = occupied_.who_stands_at(berth); other != kNobody && other != robot)
        leaving.push_back(other);
    }
    met = safe_.stuck_by(robot, arc.to, leaving);
  }
  for (const std::uint32_t other : met) {
    if (other != robot) note_met(robot, other, arc.to);
  }
  return !met.empty();
}

void MoveSteps::note_met(std::uint32_t robot, std::uint32_t other, Berth to) {
  note_kept(robot, other);
  states_[robot].met.push_back(other);
  states_[other].sent_on = {robot, to};
  states_[other].sent_in = step_;
}

/// Returns who keeps the robot from wishing for that drive.
std::uint32_t MoveSteps::hinderer(std::uint32_t robot, const BerthArc& arc, Care care) {
  const std::vector<Berth>& beside = graph_.beside(arc.to);
  const auto is_at_end = [&](Berth berth) {
    return berth == arc.to || std::binary_search(beside.begin(), beside.end(), berth);
  };
  if (care == Care::off_all_ways) {
    if (const std::uint32_t other = wished_.who_touches(arc, robot); other != kNobody) return other;
  }
  for (const Berth berth : arc.touches) {
    const std::uint32_t target = wished_.who_wishes(berth);
    const bool is_taken = target != kNobody && target != robot;
    const bool is_in_the_way = is_taken && states_[target].wish == nullptr;
    if (is_in_the_way || (is_taken && (care == Care::off_all_ways || is_at_end(berth)))) return target;
    const std::uint32_t other = occupied_.who_stands_at(berth);
    if (other == kNobody || other == robot) continue;
    const bool closes_a_circle = states_[other].is_asking;
    if (closes_a_circle || states_[other].robot.stays || states_[other].handles > 0) return other;
  }
  return kNobody;
}

void MoveSteps::stay(std::uint32_t robot) {
  const Berth here = states_[robot].robot.at;
  states_[robot].wish = nullptr;
  wished_.stay(here, graph_.beside(here), robot);
}

void MoveSteps::put_wish(std::uint32_t robot, const BerthArc* arc) {
  states_[robot].wish = arc;
  meetings_.wishes(robot, arc->to);
  safe_.put(robot, arc->to);
  wished_.drive(*arc, robot);
}

void MoveSteps::take_back_wish(std::uint32_t robot) {
  const BerthArc* const arc = std::exchange(states_[robot].wish, nullptr);
  meetings_.takes_back(robot, arc->to);
  safe_.put(robot, states_[robot].robot.at);
  wished_.take_back(*arc, robot);
}

void MoveSteps::forget_wish(std::uint32_t robot) {
  RobotInStep& state = states_[robot];
  if (!std::exchange(state.has_wish, false)) return;
  if (state.wish == nullptr) return wished_.forget_stay(state.robot.at, graph_.beside(state.robot.at), robot);
  wished_.forget_drive(*state.wish);
  meetings_.takes_back(robot, state.wish->to);
  safe_.put(robot, state.robot.at);
}

}  // namespace weft::server
