#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "clients/evaluate/floor/bounds.hpp"
#include "clients/evaluate/floor/score.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// Names what a folder's rows were measured of; rows of another study do not mix with them.
struct Study {
  std::string software;
  std::string site_sha256;    ///< of the site file's bytes
  std::string line_sha256;    ///< of the line's file
  std::string floors_sha256;  ///< of the photographs' names and sizes; empty: none
  double metres = 0.0;
};

/// Reads DIR/floor.json; without the file there are no rows. conflict: another study's, which is said; corrupt: none.
Result<Rows> read_rows(const std::filesystem::path& folder, const Study& study);
/// Writes the rows, and every promise by name with what came of it, whole or not at all. unavailable, exhausted:
/// names the file.
Result<void> write_rows(const std::filesystem::path& folder, const Study& study, const Rows& rows,
                        const std::vector<Judged>& promises);
/// Writes DIR/floor.csv, a row a (floor, part, seed).
Result<void> write_csv(const std::filesystem::path& folder, const Rows& rows);

nlohmann::json json_of(const Study& study);
/// Throws nlohmann::json::exception where it is none.
Study study_from(const nlohmann::json& study);
/// Returns one word that says of which study something is.
std::string stamp_of(const Study& study);

}  // namespace weft::evaluate::floor
