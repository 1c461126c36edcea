#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "clients/evaluate/floor/relocalise/trial.hpp"
#include "clients/evaluate/floor/rows.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// Holds the trials by row. `part` of the key: the light.
using TrialRows = std::map<RowKey, std::vector<Trial>>;

/// Reads DIR/relocalise.json; without the file there are no rows. conflict: it belongs to another study, which is
/// said; corrupt: it is none.
Result<TrialRows> read_trials(const std::filesystem::path& folder, const Study& study);
/// Returns of which study DIR/relocalise.json is; none: there is no such file. corrupt: it is none.
Result<std::optional<Study>> trials_study_in(const std::filesystem::path& folder);
/// Writes DIR/relocalise.json, whole or not at all. unavailable: names the file.
Result<void> write_trials(const std::filesystem::path& folder, const Study& study, const TrialRows& rows);
/// Writes DIR/relocalise.csv, a row a trial.
Result<void> write_trials_csv(const std::filesystem::path& folder, const TrialRows& rows);

}  // namespace weft::evaluate::floor
