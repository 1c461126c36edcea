#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "clients/evaluate/disturbances/score.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

/// Names what a folder's rows were measured of; rows of another study do not mix with them.
struct Study {
  std::string software;
  std::string site_sha256;  ///< of the site file's bytes
  std::string line_sha256;  ///< of the line's file
  double metres = 0.0;
  bool operator==(const Study&) const = default;
};

/// Holds rows by (variant, seed).
using Rows = std::map<std::pair<std::string, std::uint64_t>, Score>;

/// Describes a column of the tables: name as in the files, heading, member. They stand in order.
struct Column {
  const char* name;
  const char* heading;
  double Score::*value;
  int digits;
};
const std::vector<Column>& columns();

/// Reads DIR/disturbances.json; without the file there are no rows. conflict: it belongs to another study, which is
/// said; corrupt: it is none.
Result<Rows> read_rows(const std::filesystem::path& folder, const Study& study);
/// Writes DIR/disturbances.json, whole or not at all: beside, then renamed. unavailable, exhausted: names the file.
Result<void> write_rows(const std::filesystem::path& folder, const Study& study, const Rows& rows);
/// Writes DIR/disturbances.csv, a row a (variant, seed), in the order of `variants`.
Result<void> write_csv(const std::filesystem::path& folder, const std::vector<std::string>& variants,
                       const Rows& rows);

}  // namespace weft::evaluate
