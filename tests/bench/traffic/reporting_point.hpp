#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "agents/agent/route_task.hpp"
#include "core/protocol/messages.hpp"

namespace weft::bench {

inline constexpr double kBetweenStates_s = 0.2;

/// Stands for a robot: a point that drives what it is released at 0.6 m/s, and reports as an agent does, its state
/// five times a second.
class ReportingPoint {
 public:
  ReportingPoint(const RobotId& id, const PlaceId& at);

  /// Returns how it introduces itself.
  std::vector<msg::Message> arrive();
  /// Takes what the server says to it.
  void take(const msg::RouteOrder& order, SteadyTime now);
  void take(const msg::ClockProbe& probe, WallTime now);
  /// Drives on for the time between two states; returns what it then has to say.
  std::vector<msg::Message> live(SteadyTime now);
  /// Returns whether it drove when it lived last.
  bool drives() const { return drives_; }

 private:
  msg::Header header() { return {id_, 1, {}, ++sequence_, {}}; }
  void drive(SteadyTime now);
  msg::RobotState state();

  RobotId id_;
  std::string name_;
  std::uint64_t sequence_ = 0;
  PlaceId at_;
  std::uint32_t index_ = 0;  ///< of that place in the route
  double beyond_m_ = 0.0;    ///< driven from there
  bool drives_ = false;
  agents::RouteTask task_;
  std::vector<msg::Message> answers_;
};

}  // namespace weft::bench
