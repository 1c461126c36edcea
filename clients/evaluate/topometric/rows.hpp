#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "clients/evaluate/topometric/bounds.hpp"
#include "clients/evaluate/topometric/scenes.hpp"
#include "clients/evaluate/topometric/score.hpp"
#include "core/result.hpp"

namespace weft::evaluate::topometric {

/// Names what a folder's rows were measured of.
struct Study {
  std::string software;
  std::string scenes_sha256;
  Extent extent;
};

/// Returns the whole document: study, rows, and each bound with what came of it.
nlohmann::json document_of(const Study& study, const Rows& rows, const std::vector<Judged>& judged);

/// Reads DIR/topometric.json; without the file there are no rows. conflict: it is another study's; corrupt: it is
/// none.
Result<Rows> read_rows(const std::filesystem::path& folder, const Study& study);
/// Writes that file, whole or not at all. unavailable, exhausted: names the file.
Result<void> write_rows(const std::filesystem::path& folder, const Study& study, const Rows& rows,
                        const std::vector<Judged>& judged);
/// Writes DIR/topometric.csv: a row a trial, seed and number.
Result<void> write_csv(const std::filesystem::path& folder, const Rows& rows);
/// Writes DIR/series/TRIAL.json: what pictures show of the first seed.
Result<void> write_shown(const std::filesystem::path& folder, const std::string& trial, const Shown& shown);

}  // namespace weft::evaluate::topometric
