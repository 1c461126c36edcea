#pragma once
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "core/protocol/messages.hpp"
#include "server/base/context.hpp"

namespace weft::server {

/// Takes commands to robots and brings answers back. Each robot does them in order, one after the other; only `stop`
/// overtakes. A command is repeated until its robot answers; its number is new for every one, over restarts too.
class Commands {
 public:
  explicit Commands(Context& context) : context_(context), next_number_((context.out.epoch().value << 32U) + 1) {}

  /// Gives the command its number, and returns it.
  std::uint64_t give(msg::AgentCommand command, SteadyTime now);
  /// Returns the command that this answers; none when it was answered before.
  std::optional<msg::AgentCommand> on_reply(const msg::AgentReply& reply, SteadyTime now);
  /// Gives up whatever the robot has not answered, but `stop`. Returns what was given up.
  std::vector<msg::AgentCommand> give_up(const RobotId& robot);
  bool is_busy(const RobotId& robot) const { return queues_.contains(robot); }

  void tick(SteadyTime now);
  std::optional<SteadyTime> next() const;

 private:
  struct Waiting {
    msg::AgentCommand command;
    SteadyTime send_at;
    Duration wait{};
  };
  using Queue = std::deque<Waiting>;
  /// Returns whether the command at `index` may be sent: it is the first, or a stop.
  static bool may_go(const Queue& queue, std::size_t index) {
    return index == 0 || queue[index].command.kind == msg::AgentCommand::Kind::stop;
  }

  Context& context_;
  std::uint64_t next_number_;
  std::map<RobotId, Queue> queues_;  // no empty ones
};

}  // namespace weft::server
