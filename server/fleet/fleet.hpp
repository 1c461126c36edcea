#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/protocol/messages.hpp"
#include "core/random.hpp"
#include "server/base/context.hpp"
#include "server/fleet/incarnations.hpp"
#include "server/fleet/link_directions.hpp"
#include "server/fleet/reception.hpp"
#include "server/fleet/skew.hpp"

namespace weft::server {

/// Holds one robot as the server knows it.
struct Robot {
  RobotId id;
  std::string name;      ///< a label; from the store until the robot says it
  std::string vendor;    ///< of its bus, by its last hello
  std::string software;  ///< the agent's version, by its last hello
  std::optional<msg::RobotDescription> description;
  std::optional<msg::RobotState> state;  ///< the latest of the current incarnation
  std::optional<msg::RobotPower> power;  ///< the latest; none: it has not said
  Incarnations incarnations;
  Reception reception;
  LinkDirections directions;
  SteadyTime heard;  ///< or when the server started
  bool silent = true;
  std::string held_by;  ///< the operator who holds it: it is released no farther; empty: nobody
  bool left = false;    ///< its agent said that it was being ended, and nothing since
  ClockSkew skew;
  SteadyTime next_probe;
  std::uint64_t window_bytes = 0;   ///< sent to it since the server started
  std::uint64_t content_bytes = 0;  ///< the same
};

/// Returns why a robot cannot be given anything to do now; empty when it can be talked to.
std::string unreachable_reason(const Robot& robot);

/// Keeps the robots that are there: hellos, descriptions, states, silence, clocks. Decides nothing about goals.
class Fleet {
 public:
  Fleet(Context& context, Random random, const std::map<RobotId, std::string>& stored,
        const std::map<RobotId, std::string>& holds, SteadyTime now);

  /// Takes a hello. Returns false when the peer speaks no common protocol version and is not listened to.
  bool on_hello(const msg::Hello& hello, Now now);
  void on_description(const msg::RobotDescription& description, Now now);
  /// Takes a state. Returns the robot when it is news; null when it is an old one that came late.
  const Robot* on_state(const msg::RobotState& state, Now now);
  void on_power(const msg::RobotPower& power);
  void on_clock_reply(const msg::ClockReply& reply, Now now);

  /// Judges a peer's message before anything else is done with it. none: the peer is not known to be a robot, and
  /// this message is not one that only robots send.
  std::optional<Incarnations::Verdict> hear(const msg::Header& from, bool says_it_is_a_robot, Now now);
  /// Counts a message of a robot that is known, whatever becomes of it.
  void count(const msg::Header& from, SteadyTime now);
  bool is_refused(const PeerId& peer) const { return refused_.contains(peer); }

  void sent_window(const PeerId& to, std::size_t bytes);
  void sent_content(const PeerId& to, std::size_t bytes);

  /// Looks after silence, ended twins and clock probes. Returns robots that fell silent just now.
  std::vector<RobotId> tick(Now now);
  /// Leaves out of every robot's silence what the server itself was away.
  void excuse(Duration away, SteadyTime now);
  std::optional<SteadyTime> next() const;

  const std::map<RobotId, Robot>& robots() const { return robots_; }
  const Robot* find(const RobotId& id) const;
  /// Returns the robot's name, or its id when it has none.
  std::string name_of(const RobotId& id) const;
  /// Finds a robot by name or by 32 hex digits. When several have the name, returns the one that is heard. not_found:
  /// lists the robots that are there. refused: two of the name are heard, or several and none is; gives their ids.
  Result<RobotId> by_name(const std::string& text) const;

  /// Forgets the robot: it is listed no more and its name is free, until it is heard again. It must be silent and
  /// hold nothing.
  Result<void> forget(const RobotId& id, const std::string& who, Now now);
  /// Renames the robot until its agent says what it is called. refused: it is heard, or another one has the name.
  Result<void> rename(const RobotId& id, const std::string& name, const std::string& who, Now now);
  /// Holds the robot or lets it go, and says so for people. refused: it is so already.
  Result<std::string> hold(const RobotId& id, bool holds, const std::string& who, Now now);

 private:
  Robot& entry(const RobotId& id, Now now);
  /// Lists names, in order, for people.
  std::string listed() const;
  void named(Robot& robot, const std::string& name, Now now);
  void changed(Robot& robot, const msg::RobotState& next, Now now);
  void note(const char* kind, const Robot& robot, const std::string& cause, Now now);

  Context& context_;
  Random random_;
  Duration silent_after_;
  std::map<RobotId, Robot> robots_;
  std::set<PeerId> refused_;
};

}  // namespace weft::server
