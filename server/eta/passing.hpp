#pragma once
#include <cstdint>
#include <optional>

#include "core/network/goal.hpp"
#include "core/protocol/messages.hpp"
#include "core/time.hpp"
#include "server/eta/speeds.hpp"

namespace weft::server {

/// Makes passes of what one robot reports of the route that it follows.
class Passing {
 public:
  /// Takes a report on this version of the route. Reports may be late or lost: a time without any that is too long
  /// is left out, as is one in which the robot was stopped or had faults.
  void on_report(const Route& route, std::uint32_t at, msg::RoutePhase phase, SteadyTime now, Speeds& speeds);
  /// Learns of what the robot has driven.
  void end(Speeds& speeds);
  /// Returns the index in the route of the place that the robot has passed last; 0: it is not known.
  std::size_t at(const Route& route) const;

 private:
  struct Last {
    PlaceId place;
    std::size_t index = 0;  ///< in the route as it was then
    bool waits = false;
    SteadyTime at;
  };

  void drive(const Route& route, std::size_t from, std::size_t to, double drive_s, Speeds& speeds);
  void enter(const RunPiece& piece, Speeds& speeds);

  std::optional<Last> last_;
  std::optional<RunPiece> piece_;
  Pass pass_;
};

}  // namespace weft::server
