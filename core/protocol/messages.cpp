#include "core/protocol/messages.hpp"

namespace weft::msg {

const char* to_string(RobotMode mode) {
  switch (mode) {
    case RobotMode::idle:
      return "idle";
    case RobotMode::teaching:
      return "teaching";
    case RobotMode::driving:
      return "driving";
    case RobotMode::waiting:
      return "waiting";
    case RobotMode::stopped:
      return "stopped";
    case RobotMode::lost:
      return "lost";
    case RobotMode::faulted:
      return "faulted";
    case RobotMode::off:
      return "off";
  }
  return "unknown";
}

const char* to_string(RoutePhase phase) {
  switch (phase) {
    case RoutePhase::accepted:
      return "accepted";
    case RoutePhase::driving:
      return "driving";
    case RoutePhase::waiting:
      return "waiting";
    case RoutePhase::arrived:
      return "arrived";
    case RoutePhase::stopped:
      return "stopped";
    case RoutePhase::failed:
      return "failed";
  }
  return "unknown";
}

}  // namespace weft::msg
