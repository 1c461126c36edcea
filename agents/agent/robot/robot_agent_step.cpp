#include <utility>

#include "agents/agent/robot/robot_agent.hpp"

/// Steps the navigator; no other file does.
namespace weft::agents {
namespace {

double speed(const Motion& motion) {
  const double elapsed = seconds(motion.elapsed);
  if (motion.wheels.has_value() && elapsed > 0.0) return motion.wheels->distance_m / elapsed;
  return motion.command.linear_m_s;
}

}  // namespace

AgentOutput RobotAgent::step(const Sample& sample, SteadyTime now) {
  Navigated navigated = navigator_->step(sample, map_.view());
  condition_.frame = sample.frame;
  condition_.speed_m_s = speed(sample.motion);
  condition_.lost = navigated.lost;
  condition_.stands_for = navigated.reason;
  condition_.may_look_around = follow_.has_route() || localise_.is_asked_for();
  condition_.command = condition_.may_look_around ? navigated.command : Twist{};
  reports_.power.take(sample.charge, now);
  obey(sample.safety, navigated.fix.has_value(), now);
  outbox_.expose(navigated.exposes);
  teach_.step(navigated.kept, sample.hand_done, now);
  learn(std::move(navigated.learned_places), sample.time);
  count(navigated);
  if (navigated.fix.has_value()) take_fix(*navigated.fix, now);
  if (!sample.views.empty() && !teach_.is_active()) keep_place_.on_view(now);
  recogniser_.want(navigator_->question(), now);
  map_.follow_search(navigated.fix.has_value(), map_context(), now);
  condition_.blocked.take(condition_.allowed_command(), condition_.sees_something(), navigator_->estimate(), now);
  follow_.step(navigated, condition_.is_kept_standing(), now);
  move_window(now);
  teach_.refine(follow_.is_under_way(), now);
  return finish(now);
}

/// Stands while the base's safety holds the robot, and follows its route again once it may and has seen where it is.
void RobotAgent::obey(Safety safety, bool has_fix, SteadyTime now) {
  const bool was_kept = condition_.safety.keeps_from_driving();
  if (condition_.safety.take(safety)) {
    const std::string reason = condition_.safety.reason(config_.name);
    navigator_->stop();
    follow_.stop(reason, now);
    outbox_.note(reason);
  }
  if (has_fix) condition_.safety.fixed();
  if (was_kept && !condition_.safety.keeps_from_driving()) follow_.resume(now);
}

void RobotAgent::learn(std::vector<LearnedPlace> learned_places, SensorTime seen_at) {
  const PlaceLearning::Seen seen{.robot = config_.self, .frame = condition_.frame, .at = seen_at};
  const std::size_t taken = learning_.take(std::move(learned_places), map_.window(), seen);
  if (taken > 0) seen_["navigation: places known better"] += taken;
}

void RobotAgent::count(const Navigated& navigated) {
  for (const Refusal& refusal : navigated.refusals) ++seen_["navigation: " + std::string(refusal.reason)];
  if (navigated.fix.has_value()) ++seen_["navigation: fixes"];
}

void RobotAgent::take_fix(const Fix& fix, SteadyTime now) {
  outbox_.record({.frame = condition_.frame, .fix = fix});
  const bool is_for_teaching = teach_.on_fix();
  if (!is_for_teaching && localise_.on_fix(fix) && follow_.give_back_if_astray()) {
    condition_.command = Twist{};
    reports_.state.hurry(now);
  }
  if (std::string note = diagnostics_.add(fix); !note.empty()) outbox_.note(std::move(note));
}

void RobotAgent::move_window(SteadyTime now) {
  const std::optional<Estimate> estimate = navigator_->estimate();
  if (!estimate.has_value()) return;
  map_.recentre(spooler_.newest_durable(estimate->place.experience), map_context(), now);
}

}  // namespace weft::agents
