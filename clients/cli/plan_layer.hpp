#pragma once
#include <array>
#include <optional>
#include <ostream>
#include <string>

#include "core/ids.hpp"
#include "core/result.hpp"
#include "storage/formats/floor_plan.hpp"

namespace weft::cli {

/// Holds a floor plan to draw a network upon; the layout is in the plan's frame then.
struct Ground {
  formats::FloorPlan plan;
  std::string caption;  ///< where it is from, and how well the network lies on it
};

/// Reads a map_server file and its image, which must be a PGM. Says on `err` what of them is not understood.
Result<formats::FloorPlan> read_floor_plan(const std::string& file, std::ostream& err);

/// Returns the SHA-256 of a map_server file and then of its image, by which a registered plan is known again.
/// invalid: one of them cannot be read.
Result<ContentHash> plan_hash(const std::string& file);

/// Returns the four corners of the plan in the plan's frame.
std::array<Pose2, 4> corners_of(const formats::FloorPlan& plan);

}  // namespace weft::cli
