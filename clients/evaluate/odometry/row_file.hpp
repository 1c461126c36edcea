#pragma once
#include <filesystem>
#include <vector>

#include "clients/evaluate/floor/rows.hpp"
#include "clients/evaluate/odometry/row.hpp"
#include "core/result.hpp"

namespace weft::evaluate::odometry {

/// Reads FOLDER/odometry.json; no file is no rows. conflict: it belongs to another study, which is said; corrupt: it
/// is none.
Result<std::vector<Row>> read_odometry_rows(const std::filesystem::path& folder, const floor::Study& study);

/// Writes FOLDER/odometry.json and odometry.csv, whole or not at all. unavailable: names the file.
Result<void> write_odometry_rows(const std::filesystem::path& folder, const floor::Study& study,
                                 const std::vector<Row>& rows);

}  // namespace weft::evaluate::odometry
