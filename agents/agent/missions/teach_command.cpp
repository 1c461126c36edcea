#include "agents/agent/missions/teach_command.hpp"

namespace weft::agents {
namespace {

Result<void> check_not_stopped(const AgentConfig& config, const Condition& condition) {
  if (condition.stopped) return fail(ErrorCode::refused, config.name + " is stopped: resume it first");
  return {};
}

}  // namespace

std::vector<SitePoint> line_of(const msg::AgentCommand& command) {
  std::vector<SitePoint> along;
  along.reserve(command.along.size());
  for (const msg::AgentCommand::Point& point : command.along) along.push_back({point.x, point.y});
  return along;
}

Result<void> check_teach_start(const msg::AgentCommand& command, const AgentConfig& config,
                               const Condition& condition, bool has_route) {
  if (condition.is_faulted()) {
    return fail(ErrorCode::refused, config.name + " is out of order: " + condition.fault);
  }
  if (has_route) {
    return fail(ErrorCode::refused, config.name + " has a goal: cancel it, or wait until it is there");
  }
  if (!command.along.empty() && !config.can_be_taught_along) {
    return fail(ErrorCode::refused,
                "this body (" + config.body + ") has no hand that drives along a file: leave out --along");
  }
  return check_not_stopped(config, condition);
}

Result<void> check_next_part(const AgentConfig& config, const Condition& condition) {
  if (!config.can_be_taught_along) {
    return fail(ErrorCode::refused, "this body (" + config.body + ") has no hand");
  }
  return check_not_stopped(config, condition);
}

}  // namespace weft::agents
