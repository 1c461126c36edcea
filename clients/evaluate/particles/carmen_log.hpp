#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/pose2.hpp"
#include "core/result.hpp"

namespace weft::evaluate::particles {

/// Holds one scan of a laser that sees 180 degrees ahead, from right to left.
struct LaserScan {
  Pose2 map_from_laser;  ///< as the log was corrected: taken for the truth
  std::vector<float> ranges_m;

  /// Returns the bearing of a range: logs of an even number of ranges leave the last one out.
  double bearing_rad(std::size_t i) const;
};

/// Bounds what a log may hold.
inline constexpr std::size_t kFewestScans = 8;
inline constexpr std::size_t kMostScans = 200'000;
inline constexpr std::size_t kMostRanges = 2000;

/// Reads the FLASER lines of a CARMEN log, "FLASER n range... x y heading odometry(3) time host time"; other lines
/// are passed over. invalid, naming file and line: a line is cut or too long, a number is none, a range is negative,
/// a pose is farther than 10 km, or another number of ranges than before; naming the file: too few scans.
Result<std::vector<LaserScan>> read_carmen(std::string_view text, const std::string& file);

/// Reads such a log from a file, which may be packed by gzip. not_found; corrupt: damaged gzip.
Result<std::vector<LaserScan>> read_carmen_file(const std::filesystem::path& file);

}  // namespace weft::evaluate::particles
