#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "clients/evaluate/trial_numbers.hpp"
#include "core/result.hpp"

/// Holds the evaluation; here: how studies keep the numbers of their trials in files.
namespace weft::evaluate {

/// Returns the rows as a list for a study's JSON file.
nlohmann::json json_of(const TrialRows& rows);
/// Reads such a list. Throws nlohmann::json::exception where it is none.
TrialRows trial_rows_from(const nlohmann::json& list);

/// Writes a CSV file with a row a trial, seed and number. unavailable: names the file.
Result<void> write_trials_csv(const std::filesystem::path& file, const TrialRows& rows);

}  // namespace weft::evaluate
