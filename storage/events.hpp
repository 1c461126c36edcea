#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "core/protocol/query_messages.hpp"

namespace weft::storage {

/// Says which events are wanted; what is left out takes everything.
struct EventFilter {
  GoalId goal{};
  RobotId robot{};
  std::string kind{};       ///< this kind, or those that it begins up to a dot
  WallTime since{};         ///< not before that
  std::uint64_t after = 0;  ///< behind that number
};

struct EventPage {
  std::vector<msg::Event> events;  ///< oldest first, with their numbers
  std::uint64_t oldest = 0;        ///< number of the oldest event that is kept, whatever was asked; 0: there is none
  std::uint64_t newest = 0;
};

/// Returns whether the first events that fit are wanted, not the last: somebody reads on from a number or a time.
inline bool goes_forward(const EventFilter& filter) {
  return filter.after != 0 || filter.since != WallTime{};
}

/// Returns whether an event is of that kind: "robot" has robot.lost, and not robotics.
inline bool is_of_kind(const std::string& kind, const std::string& wanted) {
  return wanted.empty() || kind == wanted || kind.starts_with(wanted + ".");
}

inline bool fits(const EventFilter& filter, const msg::Event& event) {
  return (!filter.goal || event.goal == filter.goal) && (!filter.robot || event.robot == filter.robot) &&
         is_of_kind(event.kind, filter.kind) && event.at >= filter.since &&
         (filter.after == 0 || event.number > filter.after);
}

}  // namespace weft::storage
