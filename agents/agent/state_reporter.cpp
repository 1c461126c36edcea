#include "agents/agent/state_reporter.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr Duration kBetweenDescriptions = 10s;
constexpr Duration kMoving = 500ms;
constexpr Duration kIdle = 3s;
constexpr Duration kBetweenStates = 100ms;
constexpr double kMovingFasterThan = 0.01;  // m/s
}  // namespace

bool StateReporter::description_due(SteadyTime now) {
  if (now < describe_at_) return false;
  describe_at_ = now + kBetweenDescriptions;
  return true;
}

bool StateReporter::state_due(const msg::RobotState& state, SteadyTime now) {
  Shown now_shown = shown(state);
  if (now_shown != said_) state_at_ = std::min(state_at_, sent_at_ + kBetweenStates);
  if (now < state_at_) return false;
  said_ = std::move(now_shown);
  sent_at_ = now;
  state_at_ = now + (std::abs(state.speed_m_s) > kMovingFasterThan ? kMoving : kIdle);
  return true;
}

void StateReporter::server_restarted(SteadyTime now) {
  describe_at_ = now;
  state_at_ = now;
}

SteadyTime StateReporter::next() const {
  return std::min(describe_at_, state_at_);
}

StateReporter::Shown StateReporter::shown(const msg::RobotState& state) {
  return {.mode = state.mode,
          .localised = state.localised,
          .route = state.route,
          .version = state.route_version,
          .experience = state.experience,
          .window = state.window_digest,
          .complete = state.contents_missing == 0,
          .reason = state.reason,
          .spool_refuses = !state.spool_refuses.empty(),
          .is_deaf = state.server_unheard_s >= msg::kDeaf_s};
}

msg::RobotDescription description_of(const AgentConfig& config, const std::vector<std::string>& drives) {
  msg::RobotDescription description;
  description.name = config.name;
  description.body = config.body;
  description.methods = drives;
  description.footprint_radius_m = config.footprint_radius_m;
  description.can_be_taught_along = config.can_be_taught_along;
  description.cameras = config.cameras;
  description.knows_limits = true;
  return description;
}

}  // namespace weft::agents
