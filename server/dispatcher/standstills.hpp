#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "server/base/context.hpp"
#include "server/dispatcher/dispatcher.hpp"

namespace weft::server {

/// Names standstills within two seconds: robots that wait for one another, or for one that will not move, with
/// everyone in it and what would help. Does nothing about them.
class Standstills {
 public:
  Standstills(Context& context, const Fleet& fleet, Dispatcher& dispatcher)
      : context_(context), fleet_(fleet), dispatcher_(dispatcher) {}

  void tick(Now now);
  std::optional<SteadyTime> next() const;
  /// Returns what the robot waits for; null: it does not stand and wait. The answer is of the last time that waits
  /// were looked at.
  const Wait* wait_of(const RobotId& robot) const;
  /// Returns the standstill that the robot is in, or waits behind; empty: there is none that has lasted.
  std::string text_of(const RobotId& robot) const;
  /// Returns how many standstills there are that have lasted.
  std::size_t count() const;

 private:
  struct Key {
    std::vector<RobotId> core;
    std::optional<Stays> stays;
    auto operator<=>(const Key&) const = default;
  };
  struct Known {
    SteadyTime since;
    std::optional<SteadyTime> told_at;
    std::string text;  ///< empty: it has not lasted yet
  };

  std::vector<Standstill> look();
  void name(const Standstill& standstill, Known& known, Now now);
  void note(const char* kind, const RobotId& robot, const std::string& cause, Now now);
  std::string names_of(const std::vector<RobotId>& robots) const;
  std::string text(const Standstill& standstill) const;
  std::string why_it_stays(const Standstill& standstill) const;
  std::string links(const Standstill& standstill) const;

  Context& context_;
  const Fleet& fleet_;
  Dispatcher& dispatcher_;
  std::optional<SteadyTime> looked_at_;
  std::map<RobotId, Wait> waits_;
  std::map<Key, Known> known_;
  std::map<RobotId, Key> of_;  ///< the standstill that each robot is in
};

}  // namespace weft::server
