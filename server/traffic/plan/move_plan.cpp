#include "server/traffic/plan/move_plan.hpp"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "server/traffic/plan/drive_out.hpp"
#include "server/traffic/plan/meetings.hpp"
#include "server/traffic/plan/move_choice.hpp"
#include "server/traffic/plan/occupied_berths.hpp"
#include "server/traffic/plan/pocket_turns.hpp"
#include "server/traffic/plan/robot_in_step.hpp"
#include "server/traffic/plan/safe_states.hpp"
#include "server/traffic/plan/wished_berths.hpp"

namespace weft::server {
namespace {

/// Steps through the plan.
class Steps {
 public:
  Steps(BerthGraph& graph, Pockets& pockets, Lanes& lanes, const std::vector<PlanRobot>& robots,
        const PlanRules& rules)
      : graph_(graph),
        pockets_(pockets),
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

  MovePlan take() {
    for (std::uint32_t step = 0; step < rules_.steps; ++step) go(step);
    for (RobotInStep& state : states_) plan_.kept_by.push_back(std::move(state.kept_by));
    return std::move(plan_);
  }

 private:
  void go(std::uint32_t step) {
    look_at_pockets();
    meetings_.begin_step();
    std::stable_sort(order_.begin(), order_.end(), [this](std::uint32_t a, std::uint32_t b) {
      const PlanRobot& first = states_[a].robot;
      const PlanRobot& second = states_[b].robot;
      if (states_[a].leaves != states_[b].leaves) return states_[a].leaves;
      if (is_sent_first(a) != is_sent_first(b)) return is_sent_first(a);
      if ((first.goal == nullptr) != (second.goal == nullptr)) return first.goal != nullptr;
      if (first.priority != second.priority) return first.priority > second.priority;
      return first.waits_s != second.waits_s ? first.waits_s > second.waits_s : a < b;
    });
    for (const std::uint32_t robot : order_) {
      if (!is_there(robot) || states_[robot].has_wish) continue;
      const std::size_t decided = decided_.size();
      wish(robot, kNobody);
      if (states_[robot].wish == nullptr) forget_asked(decided + 1);
    }
    // Moves asked robots before those that were looked at later, whatever their priority.
    moving_.clear();
    for (const std::uint32_t robot : std::exchange(decided_, {})) {
      const BerthArc* const arc = states_[robot].wish;
      if (arc == nullptr) continue;
      if (const std::uint32_t other = occupied_.occupant(*arc, robot); other != kNobody) {
        note_kept(robot, other);
        continue;
      }
      if (!occupied_.keeps_off_movers(*arc, step)) continue;
      moving_.push_back(robot);
      occupied_.move(*arc, step);
    }
    for (const std::uint32_t robot : order_) forget_wish(robot);
    std::erase_if(moving_, [this](std::uint32_t robot) { return !is_safe(robot); });
    // Nobody enters a lane in the step in which another one leaves it, so all of these find the same.
    for (const std::uint32_t robot : moving_) states_[robot].first = meetings_.first(robot, states_[robot].wish->to);
    for (const std::uint32_t robot : moving_) move(robot, step);
    for (std::uint32_t robot = 0; robot < states_.size(); ++robot) get_on(robot);
  }

  /// Forgets the decisions to stay of those that were asked in vain: each may move yet for a reason of its own.
  void forget_asked(std::size_t first) {
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
  bool is_sent_first(std::uint32_t robot) const {
    const RobotInStep& state = states_[robot];
    return state.robot.is_gridlocked && state.robot.goal == nullptr && state.sent_on;
  }

  /// Returns whether nobody is stuck when the robot moves as it wishes; it is there then.
  bool is_safe(std::uint32_t robot) {
    const std::vector<std::uint32_t> stuck = safe_.stuck_by(robot, states_[robot].wish->to, {});
    for (const std::uint32_t other : stuck) {
      if (other != robot) note_kept(robot, other);
    }
    if (stuck.empty()) safe_.put(robot, states_[robot].wish->to);
    return stuck.empty();
  }

  /// Finds who is in which pocket, and who has to come out.
  void look_at_pockets() {
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
  bool can_leave_for_others(std::uint32_t robot) {
    const std::vector<PocketTurns::Wanting>& others = turns_.wanted_by(states_[robot].in);
    return std::any_of(others.begin(), others.end(), [&](const PocketTurns::Wanting& other) {
      return !meetings_.are_face_to_face(robot, other.robot);
    });
  }

  bool is_there(std::uint32_t robot) const {
    return states_[robot].drives == 0 && states_[robot].robot.at != kNoBerth;
  }

  /// Decides where the robot wants to go next; `asker` wants it away from where it stands. Returns whether it will
  /// go.
  bool wish(std::uint32_t robot, std::uint32_t asker) {
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

  /// Says what of others' wishes a wish keeps off: all that they drive through, or only where they want to stand. Who
  /// has to make way and cannot but into the way of who asks is asked again there.
  enum class Care : std::uint8_t { off_all_ways, off_where_they_end };

  bool choose(std::uint32_t robot, std::uint32_t asker) {
    RobotInStep& state = states_[robot];
    state.met.clear();
    if (asker != kNobody) return goes(robot, asker);
    if (turns_.is_refused(robot, state.robot)) {
      return clears(robot, [&](const PlanRobot& there) { return !turns_.is_refused(robot, there); });
    }
    if (turns_.is_in_a_mouth(state.robot)) {
      ++plan_.pushes;
      return clears(robot, [&](const PlanRobot& there) { return !turns_.is_in_a_mouth(there); });
    }
    if (state.robot.goal == nullptr && !state.leaves && state.sent_on && keeps_from(robot, *state.sent_on)) {
      ++plan_.pushes;
      const Meeting other = *state.sent_on;
      return clears(robot, [&](const PlanRobot& there) { return !would_keep_from(robot, there, other); });
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

  /// Returns whether the robot, where it stands, keeps the other one from going there, and could make way.
  bool keeps_from(std::uint32_t robot, const Meeting& other) {
    return !meetings_.are_face_to_face(robot, other.robot) && would_keep_from(robot, states_[robot].robot, other);
  }
  /// Returns whether it would from there: they meet, or it would be stuck when that one went where it would.
  bool would_keep_from(std::uint32_t robot, const PlanRobot& there, const Meeting& other) {
    if (meetings_.would_keep_from({there.at, there.methods}, other)) return true;
    if (!safe_.concern(other.robot, other.to, {there.at, there.methods})) return false;
    safe_.put(robot, there.at);
    const std::vector<std::uint32_t> stuck = safe_.stuck_by(other.robot, other.to, {});
    safe_.put(robot, states_[robot].robot.at);
    return std::binary_search(stuck.begin(), stuck.end(), robot);
  }

  /// Has the robot drive on to where it is out of others' way, its goal or not, round those that cannot make way.
  template <class IsOut>
  bool clears(std::uint32_t robot, IsOut&& is_out) {
    PlanRobot there = states_[robot].robot;
    const BerthArc* const first =
        drive_out(graph_, {.from = there.at,
                           .methods = there.methods,
                           .is_closed = [&](const BerthArc& arc) { return is_closed(robot, arc); },
                           .is_out =
                               [&](Berth berth) {
                                 there.at = berth;
                                 return is_out(there);
                               }});
    return first != nullptr &&
           (take(robot, *first, Care::off_all_ways) || take(robot, *first, Care::off_where_they_end));
  }

  /// Returns whether the robot does not get through there: one stands there that does not make way for it.
  bool is_closed(std::uint32_t robot, const BerthArc& arc) {
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

  bool goes(std::uint32_t robot, std::uint32_t asker) {
    const std::vector<MoveChoice> choices = this->choices(robot, asker);
    const auto takes = [&](Care care) {
      return std::any_of(choices.begin(), choices.end(), [&](const MoveChoice& choice) {
        const bool is_taken = take(robot, *choice.arc, care);
        states_[robot].is_kept_known = states_[robot].is_kept_known || !states_[robot].kept_by.empty();
        return is_taken;
      });
    };
    return takes(Care::off_all_ways) || (asker != kNobody && takes(Care::off_where_they_end));
  }

  /// Returns where the robot would go, the best first; who is asked to make way goes anywhere.
  std::vector<MoveChoice> choices(std::uint32_t robot, std::uint32_t asker) {
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
  bool take(std::uint32_t robot, const BerthArc& arc, Care care) {
    if (const std::uint32_t other = hinderer(robot, arc, care); other != kNobody) {
      note_kept(robot, other);
      return false;
    }
    if (would_meet(robot, arc)) return false;
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
  bool would_meet(std::uint32_t robot, const BerthArc& arc) {
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

  void note_met(std::uint32_t robot, std::uint32_t other, Berth to) {
    note_kept(robot, other);
    states_[robot].met.push_back(other);
    states_[other].sent_on = {robot, to};
  }

  /// Notes who keeps the robot where it stands at first, from where it wants to go most.
  void note_kept(std::uint32_t robot, std::uint32_t other) {
    if (!states_[robot].is_kept_known) states_[robot].kept_by.push_back(other);
  }

  /// Returns who keeps the robot from wishing for that drive.
  std::uint32_t hinderer(std::uint32_t robot, const BerthArc& arc, Care care) {
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

  void stay(std::uint32_t robot) {
    const Berth here = states_[robot].robot.at;
    states_[robot].wish = nullptr;
    wished_.stay(here, graph_.beside(here), robot);
  }

  void put_wish(std::uint32_t robot, const BerthArc* arc) {
    states_[robot].wish = arc;
    meetings_.wishes(robot, arc->to);
    safe_.put(robot, arc->to);
    wished_.drive(*arc, robot);
  }

  void take_back_wish(std::uint32_t robot) {
    const BerthArc* const arc = std::exchange(states_[robot].wish, nullptr);
    meetings_.takes_back(robot, arc->to);
    safe_.put(robot, states_[robot].robot.at);
    wished_.take_back(*arc, robot);
  }

  void forget_wish(std::uint32_t robot) {
    RobotInStep& state = states_[robot];
    if (!std::exchange(state.has_wish, false)) return;
    if (state.wish == nullptr) return wished_.forget_stay(state.robot.at, graph_.beside(state.robot.at), robot);
    wished_.forget_drive(*state.wish);
    meetings_.takes_back(robot, state.wish->to);
    safe_.put(robot, state.robot.at);
  }

  void move(std::uint32_t robot, std::uint32_t step) {
    RobotInStep& state = states_[robot];
    const BerthArc* const arc = std::exchange(state.wish, nullptr);
    plan_.moves[robot].push_back({arc, state.robot.at, step, std::exchange(state.first, {})});
    occupied_.leave(state.robot.at);
    state.robot.at = arc->to;
    meetings_.moves(robot, arc->to);
    state.is_kept_known = true;
    occupied_.stand(arc->to, robot);
    if (is_at_goal(robot)) arrive(robot, rules_.handling + 1);
  }

  bool is_at_goal(std::uint32_t robot) const {
    const PlanRobot& known = states_[robot].robot;
    return known.goal != nullptr && known.is_goal_at_hand && known.goal->from_m(known.at) == 0.0;
  }

  void arrive(std::uint32_t robot, std::uint32_t handles) {
    states_[robot].robot.goal = nullptr;
    states_[robot].handles = handles;
  }

  void get_on(std::uint32_t robot) {
    RobotInStep& state = states_[robot];
    state.wish = nullptr;
    if (state.handles > 0) --state.handles;
    if (state.drives == 0 || state.robot.stays) return;
    occupied_.have_driven_through(state.robot.behind[state.robot.behind.size() - state.drives], robot);
    --state.drives;
  }

  BerthGraph& graph_;
  Pockets& pockets_;
  PocketTurns turns_;
  Meetings meetings_;
  SafeStates safe_;
  PlanRules rules_;
  std::vector<RobotInStep> states_;
  std::vector<std::uint32_t> order_;
  std::vector<std::uint32_t> decided_;  ///< who has a wish in this step, in the order in which it was decided
  std::vector<std::uint32_t> moving_;
  OccupiedBerths occupied_;
  WishedBerths wished_;
  MovePlan plan_;
};

}  // namespace

MovePlan plan_moves(BerthGraph& graph, Pockets& pockets, Lanes& lanes, const std::vector<PlanRobot>& robots,
                    const PlanRules& rules) {
  return Steps(graph, pockets, lanes, robots, rules).take();
}

}  // namespace weft::server
