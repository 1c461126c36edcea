#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "core/protocol/messages.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// What was refused, by name, and how often.
using Counters = std::map<std::string, std::uint64_t>;

/// The agent's side of its relation to the server: who the server is, and the header of everything the agent says.
class Session {
 public:
  /// `own` is the agent's hello; its protocol range is what this program speaks.
  Session(msg::Hello own, SteadyTime now);

  enum class Heard { known, restarted, refused };
  /// A server's hello. refused: a lower epoch than heard before, a second server in the same epoch, or no protocol
  /// version in common.
  Heard hear(const msg::Hello& hello, SteadyTime now);
  /// The header of any other message of the server's. The same rules hold.
  Heard hear(const msg::Header& header, SteadyTime now);

  /// The server has answered something that this incarnation asked: what it says from here on it says to us.
  void answered(const msg::Header& header);
  /// False for orders that may have been meant for an earlier incarnation of this robot and were late on the way.
  bool is_meant_for_me(const msg::Header& header, SteadyTime now) const;

  /// For the next message of this agent.
  msg::Header header();
  /// Our hello, when it is time to (again) say it.
  std::optional<msg::Hello> due(SteadyTime now);
  SteadyTime next() const { return next_hello_; }
  /// Nothing could be heard for so long until now.
  void was_away(Duration away, SteadyTime now);

  bool heard_server() const { return server_incarnation_.has_value(); }
  Epoch epoch() const { return epoch_; }
  /// Why this agent cannot work with its server; empty when it can.
  const std::string& incompatible() const { return incompatible_; }
  const Counters& counters() const { return counters_; }

 private:
  Heard hear(Epoch epoch, std::uint64_t incarnation, SteadyTime now);

  msg::Hello own_;
  SteadyTime started_;
  SteadyTime next_hello_;
  std::uint64_t sequence_ = 0;
  Epoch epoch_;
  std::optional<std::uint64_t> server_incarnation_;
  struct Fence {
    Epoch epoch;
    std::uint64_t sequence = 0;
  };
  std::optional<Fence> fence_;
  std::string incompatible_;
  Counters counters_;
};

}  // namespace weft::agents
