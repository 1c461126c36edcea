#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/network/goal.hpp"
#include "core/protocol/messages.hpp"
#include "server/base/counters.hpp"

namespace weft::server {

/// Holds how one robot is, in numbers.
struct RobotFigures {
  RobotId id;
  std::string name;  ///< may be empty
  bool is_heard = false;
  bool was_ended = false;  ///< its agent, in good order: nobody misses it
  bool are_twins = false;
  bool is_deaf = false;
  double silent_s = 0.0;
  msg::RobotMode mode = msg::RobotMode::off;
  bool is_localised = false;
  bool waits = false;
  bool is_in_standstill = false;
  double clock_skew_s = 0.0;  ///< ahead of the server's
  double blind_m = 0.0;
  std::optional<double> charge;  ///< share of full; none: it does not say
  std::uint64_t contents_missing = 0;
  std::uint64_t memory_bytes = 0;
  std::uint64_t window_bytes = 0;  ///< sent to it since the server started
  std::uint64_t content_bytes = 0;
  std::uint64_t messages_heard = 0;
  std::uint64_t messages_missed = 0;
  std::uint32_t spool_batches = 0;
  std::optional<std::uint64_t> spool_free_bytes;
  bool spool_refuses = false;
};

/// Holds how the server and its fleet are, in numbers, at one moment.
struct Figures {
  Epoch epoch;
  Revision revision;
  std::uint64_t experiences = 0, places = 0, stitches = 0;
  std::uint64_t contents = 0, content_bytes = 0;  ///< of the store
  std::uint64_t disk_free_bytes = 0;
  bool store_refuses = false;  ///< the last write failed
  std::uint64_t batches_acknowledged = 0, batches_refused = 0;
  std::uint64_t intake_bytes = 0;  ///< reserved for contents on their way
  std::uint64_t windows = 0, windows_behind = 0;
  std::uint64_t contents_to_send = 0;
  std::uint64_t recognitions_waiting = 0;
  std::map<GoalState, std::uint64_t> goals;
  double oldest_goal_s = 0.0;  ///< since it was asked for, of those that have not ended; 0: there is none
  std::uint64_t standstills = 0;
  std::vector<RobotFigures> robots;
  Counters counters;
};

}  // namespace weft::server
