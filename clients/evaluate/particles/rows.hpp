#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "clients/evaluate/particles/trial.hpp"
#include "core/result.hpp"

namespace weft::evaluate::particles {

/// Reads the rows that a study has left in FILE; none where there is no such file. Errors of read_rows_of().
Result<std::vector<TrialRow>> read_rows(const std::filesystem::path& file, const nlohmann::json& study);

/// Writes FILE with the study and the rows, whole or not at all. unavailable: names the file.
Result<void> write_rows(const std::filesystem::path& file, const nlohmann::json& study,
                        const std::vector<TrialRow>& rows);

/// Writes the same rows as CSV.
Result<void> write_rows_csv(const std::filesystem::path& file, const std::vector<TrialRow>& rows);

/// Bounds what comes of a log, in the mean over the seeds; 0: nothing is asked.
struct Asked {
  double mean_m = 0.0;
  double p95_m = 0.0;
  double found_after = 0.0;  ///< updates, of each seed
};
/// Returns what is asked of a log by its name, alphas of 0.2; of one that is not named, that no seed is lost.
Asked asked_of(const std::string& log, double alpha, bool is_anywhere);

/// Holds how a study's rows stand against what is asked.
struct Judged {
  std::string table;  ///< Markdown: a row a seed, then the means beside what is asked
  bool is_met = false;
};
Judged judge(const std::vector<TrialRow>& rows, const Asked& asked, bool is_anywhere);

/// Returns the same as one JSON document: study, rows, asked (null: nothing is), is_met.
nlohmann::json judged_document(const nlohmann::json& study, const std::vector<TrialRow>& rows, const Asked& asked,
                               bool is_met);

}  // namespace weft::evaluate::particles
