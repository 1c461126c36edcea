#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "agents/methods/topometric/content.hpp"
#include "core/bytes.hpp"
#include "core/geometry/pose2.hpp"
#include "core/result.hpp"

namespace weft::bench {

/// Describes a place of a simulated run, with what is stored of it.
struct RunPlace {
  std::string site;
  Pose2 at;  ///< true
  Bytes bytes;
  agents::TopometricContent content;
};

/// Holds places that one robot was taught, and what another one sees there on another day.
struct PlaceRuns {
  std::vector<RunPlace> known;
  std::vector<RunPlace> seen;
};

/// Drives the lines of the four sites of deploy/sites/topometric by hand, level11 and hall in both directions, and
/// then as another robot on another day. `is_quick`: 6 m of each. Errors of sites, bodies and the method.
Result<PlaceRuns> drive_places(const std::filesystem::path& sites, bool is_quick);

}  // namespace weft::bench
