#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "agents/agent/server_silence.hpp"
#include "core/protocol/messages.hpp"
#include "core/random.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// Counts of refused messages, by the name of the refusal.
using Counters = std::map<std::string, std::uint64_t>;

/// Keeps the agent's side of its relation to the server: who the server is, and the header of everything the agent
/// says. Takes one that speaks in a higher epoch for a mere claimant at first: the agent's hello asks with a random
/// number; a hello that answers it shows that its sender lives, and makes it the server.
class Session {
 public:
  /// Begins with the agent's hello, `own`; its protocol range is what this program speaks.
  Session(msg::Hello own, Random random, SteadyTime now);

  enum class Heard { known, restarted, refused };
  /// Takes in a server's hello. refused: a lower epoch than heard before, a second server in the same epoch, a claim
  /// that is not confirmed yet, or no protocol version in common.
  Heard hear(const msg::Hello& hello, SteadyTime now);
  /// Takes in the header of any other message of the server's. The result is as for a hello, but a header confirms no
  /// claim.
  Heard hear(const msg::Header& header, SteadyTime now);

  /// Notes that the server has answered what this incarnation asked: what it says from here on it says to us.
  void answered(const msg::Header& header);
  /// Returns false for orders that may be late and have been meant for an earlier incarnation of this robot.
  bool is_meant_for_me(const msg::Header& header, SteadyTime now) const;

  /// Returns the header for the next message of this agent.
  msg::Header header();
  /// Returns our hello, when it is time to (again) say it.
  std::optional<msg::Hello> due(SteadyTime now);
  /// Drops claims that nobody has confirmed in time. Returns what a log should say of each.
  std::vector<std::string> drop_claims(SteadyTime now);
  SteadyTime next() const;
  /// Takes note that nothing could be heard for so long until now.
  void was_away(Duration away, SteadyTime now);

  /// Returns for how long nothing has come from the server.
  const ServerSilence& silence() const { return silence_; }
  bool heard_server() const { return server_incarnation_.has_value(); }
  Epoch epoch() const { return epoch_; }
  /// Returns why this agent cannot work with its server; empty when it can.
  const std::string& incompatible() const { return incompatible_; }
  const Counters& counters() const { return counters_; }

 private:
  struct Speaker {
    Epoch epoch;
    std::uint64_t incarnation = 0;
    bool operator==(const Speaker&) const = default;
  };
  struct Claim {
    Speaker who;
    SteadyTime until;
  };
  Heard hear(const Speaker& who, bool is_confirmed, SteadyTime now);
  bool is_server(const Speaker& who) const;
  void claim(const Speaker& who, SteadyTime now);
  /// Returns whether the hello answers what is being asked now.
  bool answers(const msg::Hello& hello) const;

  msg::Hello own_;
  Random random_;
  SteadyTime started_;
  SteadyTime next_hello_;
  ServerSilence silence_;
  std::uint64_t sequence_ = 0;
  Epoch epoch_;
  std::optional<std::uint64_t> server_incarnation_;
  std::vector<Claim> claims_;  ///< oldest first
  struct Fence {
    Epoch epoch;
    std::uint64_t sequence = 0;
  };
  std::optional<Fence> fence_;
  std::string incompatible_;
  Counters counters_;
};

}  // namespace weft::agents
