#pragma once
#include <compare>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <vector>

#include "clients/evaluate/floor/drive.hpp"
#include "clients/evaluate/floor/trace.hpp"

namespace weft::evaluate::floor {

/// Names what was driven: mapping; a repeat is named by its light.
inline constexpr const char* kMapping = "mapping";

struct RowKey {
  std::string kind;
  std::string part;  ///< kMapping, or a light
  std::uint64_t seed = 1;
  auto operator<=>(const RowKey&) const = default;
};

/// Holds what one part came to. NaN where it has nothing to say, or there was nothing to measure.
struct Score {
  static constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

  double metres = kNothing;  ///< truly driven, all runs of the part together
  // Mapping.
  double speed_percent = kNothing;
  double speed_stamped_percent = kNothing;  ///< by the samples' own stamps, their jitter included
  double speed_wrong_mount_percent = kNothing;
  double speed_fast_percent = kNothing;
  // Repeating.
  double arrived = kNothing;  ///< 1: it stands at the goal and says so
  double consistency_percent = kNothing;
  double blind_m = kNothing;  ///< longest distance between right fixes
  double lateral_rmse_mm = kNothing;
  double lateral_worst_mm = kNothing;
  double heading_rms_deg = kNothing;
  double goal_mm = kNothing;
  double goal_deg = kNothing;
  double fixes = kNothing;
  double wrong_fixes = kNothing;
  // Both: how often the 95 % region of odometry's covariance held the truth; mapping by the calibrated camera,
  // repeating by one that is not.
  double held_1m_percent = kNothing;
  double held_10m_percent = kNothing;
  double seconds = kNothing;  ///< that it took to compute, the simulation included

  std::vector<double> blind_distances_m;  ///< all of them
  std::map<std::string, std::uint64_t>
      refusals;  ///< how often localisation or odometry refused a view, by its reason
};

/// Describes one number of the tables: name as in the files, heading, digits. They stand in order.
struct Column {
  const char* name;
  const char* heading;
  double Score::*value;
  int digits;
};
const std::vector<Column>& columns();

using Rows = std::map<RowKey, Score>;

Score score_of_mapping(const Trace& taught, const Trace& wrong_mount, const Trace& fast);
Score score_of_repeat(const Taught& taught, const Repeated& repeated);

}  // namespace weft::evaluate::floor
