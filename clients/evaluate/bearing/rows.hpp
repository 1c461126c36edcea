#pragma once
#include <cstdint>
#include <filesystem>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate::bearing {

/// Holds what one trial with one seed has given.
struct Score {
  static constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

  std::vector<double> after_loop_m;  ///< distance from where it believes to be, at the end of each loop
  std::string ended;                 ///< why it stands; empty: all loops were driven
  double metres = 0.0;               ///< driven
  double landmark_m = kNothing;      ///< l of the scene
  double band_m = kNothing;          ///< the first loop against the model with that l

  /// Returns the error after so many loops, in metres. NaN: it has not come so far.
  double after(std::size_t loops) const { return loops <= after_loop_m.size() ? after_loop_m[loops - 1] : kNothing; }
};

using RowKey = std::pair<std::string, std::uint64_t>;  // trial, seed
using Rows = std::map<RowKey, Score>;

/// Names what a folder's rows were measured of.
struct Study {
  std::string software;
  std::string scenes_sha256;
};

/// Reads DIR/bearing.json; without the file there are no rows. conflict: it is another study's; corrupt: it is none.
Result<Rows> read_rows(const std::filesystem::path& folder, const Study& study);
/// Writes rows and bounds, whole or not at all. unavailable, exhausted: names the file.
Result<void> write_rows(const std::filesystem::path& folder, const Study& study, const Rows& rows, Seeds seeds);
/// Writes DIR/bearing.csv: a row a trial, seed and loop.
Result<void> write_csv(const std::filesystem::path& folder, const Rows& rows);

}  // namespace weft::evaluate::bearing
