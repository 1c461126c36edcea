#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "agents/agent/experience_ids.hpp"
#include "agents/agent/spooler.hpp"
#include "agents/navigation/navigator.hpp"
#include "core/network/network.hpp"
#include "core/network/window.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// Collects what a drive has shown of the map's places, and hands it in when the drive has ended.
class PlaceLearning {
 public:
  struct Seen {
    RobotId robot;
    std::uint64_t frame = 0;
    SensorTime at{};
  };
  /// Takes what was learned upon contents that the window still has; the rest is void.
  /// Returns how many were taken.
  std::size_t take(std::vector<LearnedPlace> learned_places, const Window& window, const Seen& seen);
  /// Spools what has been learned when the robot does not drive, and on a long drive now and then. Returns a note for
  /// the log; empty: nothing was due.
  std::string hand_in(bool drives, Spooler& spooler, ExperienceIds& ids, SteadyTime now);

 private:
  struct Learned {
    Place place;
    Bytes content;
  };
  std::map<PlaceId, Learned> learned_;
};

}  // namespace weft::agents
