#include "agents/agent/standing.hpp"

namespace weft::agents {
namespace {

constexpr const char* kStoppedByOperator = "stopped by an operator";
constexpr const char* kBlocked = "it is asked to drive and does not move: see what holds it";
constexpr const char* kStandsBefore =
    "something stands in its way: after a while it goes another way, if there is one";

std::string reason_of_waiting(const Standing& standing) {
  if (!standing.safety.empty()) return standing.safety;
  if (standing.condition.sees_something()) return kStandsBefore;
  if (!standing.route_waits_for.empty()) return standing.route_waits_for;
  const std::string& given = standing.task.route()->reason;
  return given.empty() ? standing.condition.stands_for : given;
}

/// Returns what is said of a robot that has nothing more urgent to say.
std::string beside(const Standing& standing) {
  return standing.refines.empty() ? standing.notice : standing.refines;
}

std::string reason_of_idling(const Standing& standing) {
  if (!standing.teaching_failure.empty()) return standing.teaching_failure;
  return standing.searches.empty() ? beside(standing) : standing.searches;
}

}  // namespace

msg::RobotMode mode_of(const Standing& standing) {
  const Condition& condition = standing.condition;
  if (condition.is_faulted()) return msg::RobotMode::faulted;
  if (standing.taught.has_value()) return msg::RobotMode::teaching;
  if (condition.stopped || condition.safety.holds()) return msg::RobotMode::stopped;
  if (condition.lost) return msg::RobotMode::lost;
  if (!standing.task.route().has_value() || standing.task.arrived()) return msg::RobotMode::idle;
  return standing.task.phase() == msg::RoutePhase::driving ? msg::RobotMode::driving : msg::RobotMode::waiting;
}

std::string reason_of(const Standing& standing) {
  if (!standing.incompatible.empty()) return standing.incompatible;
  switch (mode_of(standing)) {
    case msg::RobotMode::faulted:
      return standing.condition.fault;
    case msg::RobotMode::teaching:
      return standing.condition.stopped ? std::string(kStoppedByOperator) : *standing.taught;
    case msg::RobotMode::stopped:
      return standing.safety.empty() ? std::string(kStoppedByOperator) : standing.safety;
    case msg::RobotMode::lost:
      return standing.condition.stands_for;
    case msg::RobotMode::waiting:
      return reason_of_waiting(standing);
    case msg::RobotMode::idle:
      return reason_of_idling(standing);
    case msg::RobotMode::driving:
      if (standing.condition.blocked.is_blocked()) return kBlocked;
      break;
    case msg::RobotMode::off:
      break;
  }
  return beside(standing);
}

}  // namespace weft::agents
