#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "clients/evaluate/floor/bounds.hpp"
#include "clients/evaluate/floor/score.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// What a folder's rows were measured of; rows of another study do not mix with them.
struct Study {
  std::string software;
  std::string site_sha256;    ///< of the site file's bytes
  std::string line_sha256;    ///< of the line's file
  std::string floors_sha256;  ///< of the photographs' names and sizes; empty: none
  double metres = 0.0;
};

/// DIR/floor.json; no file is no rows. conflict: it belongs to another study, which is said; corrupt: it is none.
Result<Rows> read_rows(const std::filesystem::path& folder, const Study& study);
/// The rows, and every promise by name with what came of it. Whole or not at all. unavailable, exhausted: names the
/// file.
Result<void> write_rows(const std::filesystem::path& folder, const Study& study, const Rows& rows,
                        const std::vector<Judged>& promises);
/// DIR/floor.csv, a row a (floor, part, seed).
Result<void> write_csv(const std::filesystem::path& folder, const Rows& rows);

nlohmann::json json_of(const Study& study);
/// Throws nlohmann::json::exception where it is none.
Study study_from(const nlohmann::json& study);
/// One word that says of which study something is.
std::string stamp_of(const Study& study);

}  // namespace weft::evaluate::floor
