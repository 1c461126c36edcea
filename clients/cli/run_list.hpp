#pragma once
#include <vector>

#include "core/network/window.hpp"

namespace weft::cli {

/// Describes a run as far as it is in a network.
struct Run {
  ExperienceId id;
  std::size_t places = 0;
  PlaceId middle;  ///< in the order of its places
  RobotId robot;
  bool is_imported = false;
};

/// Returns the network's runs, the longest first.
std::vector<Run> runs_of(const Window& network);

}  // namespace weft::cli
