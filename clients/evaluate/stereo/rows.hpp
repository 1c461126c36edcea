#pragma once
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "clients/evaluate/stereo/dense.hpp"
#include "clients/evaluate/stereo/score.hpp"

namespace weft::evaluate::stereo {

/// Holds what a study has measured so far.
struct Rows {
  std::vector<RateRow> rates;
  std::optional<DenseRow> dense;

  /// Returns the row of a rate; null: it is not there yet.
  const RateRow* find(std::size_t every) const;
};

/// Reads the rows that a study has left in FILE; none where there is no such file. Errors of read_rows_of().
Result<Rows> read_rows(const std::filesystem::path& file, const nlohmann::json& study);
/// Writes FILE with the study and the rows, whole or not at all. unavailable: names the file.
Result<void> write_rows(const std::filesystem::path& file, const nlohmann::json& study, const Rows& rows);
/// Writes the same as CSV, a line a rate and method.
Result<void> write_rows_csv(const std::filesystem::path& file, const Rows& rows);

/// Bounds the product's row; 0: nothing is asked. That it is no worse than the baseline is always asked.
struct Asked {
  double ate_m = 0.0;
  double ms = 0.0;
};
/// Returns what is asked of a recording by its name, at that rate; of any that is at rest, 1 mm.
Asked asked_of(const std::string& recording, const RateRow& row);

/// Holds how a study's rows stand against what is asked.
struct Judged {
  std::string table;  ///< Markdown
  std::string json;   ///< one line
  bool is_met = false;
};
Judged judge(const std::string& recording, const Rows& rows);

}  // namespace weft::evaluate::stereo
