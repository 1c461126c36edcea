#pragma once
#include "clients/evaluate/trial_numbers.hpp"

namespace weft::evaluate::topometric {

/// Names the trials; the names stand in the files.
namespace trial {
inline constexpr const char* kMap = "map";                 ///< level11 is taught
inline constexpr const char* kDepth = "depth";             ///< dense depth beside the site's
inline constexpr const char* kDeliveries = "deliveries";   ///< three goals in turn on that map, with blackouts
inline constexpr const char* kOneWay = "one-way";          ///< taught one way, driven there and back
inline constexpr const char* kOtherRobot = "other-robot";  ///< driven by a robot that has taught nothing
inline constexpr const char* kShortcut = "shortcut";       ///< an S is taught, its ends are joined by a straight way
inline constexpr const char* kObstacles = "obstacles";     ///< crates and persons that were not there
inline constexpr const char* kBlocked = "blocked";         ///< a corridor is closed
inline constexpr const char* kKidnapped = "kidnapped";     ///< put down anywhere on a map that is known
inline constexpr const char* kMerge = "merge";             ///< two robots teach ways that meet, told nothing
inline constexpr const char* kAliasing = "aliasing";       ///< two robots teach aisles that look alike and never meet
inline constexpr const char* kNight = "night";             ///< 30 minutes of deliveries
}  // namespace trial

using Score = TrialNumbers;
using RowKey = TrialKey;
using Rows = TrialRows;
using Shown = ShownLines;
using Measured = MeasuredTrial;

}  // namespace weft::evaluate::topometric
