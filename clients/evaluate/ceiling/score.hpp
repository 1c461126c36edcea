#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

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

/// Holds what a trial with one seed has come to: numbers by name, units in the names.
struct Score {
  static constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

  std::map<std::string, double> values;
  /// Returns the number; NaN: the trial has none of that name.
  double value(const std::string& name) const {
    const auto found = values.find(name);
    return found == values.end() ? kNothing : found->second;
  }
};

using RowKey = std::pair<std::string, std::uint64_t>;  ///< trial, seed
using Rows = std::map<RowKey, Score>;

/// Holds lines of points for the pictures, by name.
using Shown = std::map<std::string, std::vector<std::array<double, 2>>>;

struct Measured {
  Score score;
  Shown shown;
};

}  // namespace weft::evaluate::ceiling
