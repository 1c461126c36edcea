#pragma once
#include "clients/evaluate/trial_numbers.hpp"

namespace weft::evaluate::ceiling {

/// Names the trials; the names stand in the files.
namespace trial {
inline constexpr const char* kFrames = "frames";           ///< a recording of a real ceiling
inline constexpr const char* kLine = "line";               ///< taught, and driven by the same robot the next day
inline constexpr const char* kOther = "other";             ///< driven by another robot whose mount is off
inline constexpr const char* kChange = "change";           ///< driven when the hall has changed
inline constexpr const char* kLoop = "loop";               ///< taught round a rack: the map itself
inline constexpr const char* kFound = "found";             ///< robots that know nothing, put down anywhere
inline constexpr const char* kFoundHalf = "found-half";    ///< the same with half of the lamps off
inline constexpr const char* kFoundLamps = "found-lamps";  ///< the same below a grid of lamps and nothing else
}  // namespace trial

using Score = TrialNumbers;
using RowKey = TrialKey;
using Rows = TrialRows;
using Shown = ShownLines;
using Measured = MeasuredTrial;

}  // namespace weft::evaluate::ceiling
