#include "core/network/goal.hpp"

namespace weft {

const char* to_string(GoalState state) {
  switch (state) {
    case GoalState::pending:
      return "pending";
    case GoalState::assigned:
      return "assigned";
    case GoalState::executing:
      return "executing";
    case GoalState::paused:
      return "paused";
    case GoalState::succeeded:
      return "succeeded";
    case GoalState::failed:
      return "failed";
    case GoalState::cancelled:
      return "cancelled";
    case GoalState::rejected:
      return "rejected";
  }
  return "unknown";
}

const char* to_string(GoalKind kind) {
  switch (kind) {
    case GoalKind::operator_asked:
      return "operator";
    case GoalKind::yield:
      return "yield";
    case GoalKind::charge:
      return "charge";
    case GoalKind::park:
      return "park";
  }
  return "unknown";
}

bool is_terminal(GoalState state) {
  return state == GoalState::succeeded || state == GoalState::failed || state == GoalState::cancelled ||
         state == GoalState::rejected;
}

}  // namespace weft
