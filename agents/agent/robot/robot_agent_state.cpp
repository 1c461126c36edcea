#include "agents/agent/robot/robot_agent.hpp"

#include "core/utf8.hpp"

namespace weft::agents {
namespace {

constexpr std::size_t kLongestRefusal = 1024;  ///< bytes

void add_to(Counters& all, const Counters& more) {
  for (const auto& [name, count] : more) all[name] += count;
}

}  // namespace

Counters RobotAgent::counters() const {
  Counters all = session_.counters();
  add_to(all, map_.replica().counters());
  add_to(all, map_.contents().counters());
  add_to(all, seen_);
  return all;
}

std::vector<Diagnostic> RobotAgent::diagnostics() const {
  return diagnostics_.all(navigator_->diagnostics());
}

std::string RobotAgent::trouble() const {
  const std::string& refuses = disk_.spool->refuses();
  return refuses.empty() ? std::string() : "its spool refuses what it is to keep: " + refuses;
}

AgentFigures RobotAgent::figures(SteadyTime now) const {
  return {.state = state(now),
          .epoch = session_.epoch(),
          .window_places = map_.window().places.size(),
          .counters = counters()};
}

Standing RobotAgent::standing() const {
  return {.condition = condition_,
          .task = follow_.task(),
          .incompatible = session_.incompatible(),
          .taught = teach_.is_active() ? std::optional(teach_.waits_for()) : std::nullopt,
          .teaching_failure = teach_.failure(),
          .searches = localise_.describe(),
          .route_waits_for = follow_.waits_for(),
          .notice = diagnostics_.notice(),
          .safety = condition_.safety.reason(config_.name),
          .refines = teach_.refines()};
}

msg::RobotState RobotAgent::state(SteadyTime now) const {
  const Standing stands = standing();
  msg::RobotState state;
  state.name = config_.name;
  state.mode = mode_of(stands);
  if (const std::optional<Estimate> estimate = navigator_->estimate(); estimate.has_value()) {
    state.localised = !condition_.lost;
    state.place = estimate->place;
    state.place_from_robot = estimate->place_from_robot;
    state.blind_m = estimate->blind_m;
  }
  state.speed_m_s = condition_.speed_m_s;
  state.frame = condition_.frame;
  state.experience = teach_.experience().value_or(ExperienceId{});
  if (const std::optional<Route>& route = follow_.route(); route.has_value()) {
    state.goal = route->goal;
    state.route = route->id;
    state.route_version = route->version;
  }
  state.window_revision = map_.window().revision;
  state.window_digest = map_.replica().digest();
  state.contents_missing = map_.contents().missing();
  state.memory_bytes = map_.contents().bytes();
  state.memory_cap_bytes = config_.content_cache_bytes;
  state.diagnostics = diagnostics();
  state.safety = condition_.shown();
  state.spool_batches = static_cast<std::uint32_t>(spooler_.pending());
  state.spool_free_bytes = spooler_.free_bytes();
  state.reason = reason_of(stands);
  state.server_unheard_s = seconds(session_.silence().unheard(now));
  state.server_gap_s = seconds(session_.silence().longest(now));
  state.spool_refuses = as_utf8(disk_.spool->refuses(), kLongestRefusal);
  return state;
}

}  // namespace weft::agents
