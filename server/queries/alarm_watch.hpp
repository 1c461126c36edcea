#pragma once
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/protocol/query_messages.hpp"
#include "server/base/counters.hpp"
#include "server/base/now.hpp"

namespace weft::server {

/// Remembers since when each alarm holds, and whether messages were refused lately. It is shown what is wrong again
/// and again; an alarm that is missing once has ended.
class AlarmWatch {
 public:
  /// Gives the alarms that do not know it the time since when they are seen, and adds the one on refused messages.
  std::vector<msg::Alarm> seen(std::vector<msg::Alarm> alarms, const Counters& counters, Now now);

 private:
  void count(const Counters& counters, Now now);
  std::optional<msg::Alarm> refused(Now now) const;

  using Key = std::pair<msg::AlarmKind, RobotId>;
  std::map<Key, WallTime> since_;
  Counters counted_;  ///< of refused messages alone
  struct Refused {
    WallTime since{};
    SteadyTime last{};
    std::string reason;  ///< the latest
    std::uint64_t times = 0;
  };
  std::optional<Refused> refused_;
};

}  // namespace weft::server
