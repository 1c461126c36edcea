#pragma once
#include <filesystem>
#include <map>
#include <optional>

#include "clients/evaluate/floor/attempts/tally.hpp"
#include "clients/evaluate/floor/rows.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// What a folder of attempts belongs to.
struct AttemptsStudy {
  Study study;
  std::size_t attempts_a_row = 0;
};
/// `part` of the key: the light.
using AttemptRows = std::map<RowKey, Tally>;

/// DIR/attempts.json; no file is no rows. conflict: it belongs to another study, which is said; corrupt: it is none.
Result<AttemptRows> read_attempts(const std::filesystem::path& folder, const AttemptsStudy& study);
/// Of which study DIR/attempts.json is; none: there is no such file. corrupt: it is none.
Result<std::optional<AttemptsStudy>> attempts_study_in(const std::filesystem::path& folder);
/// Whole or not at all. unavailable: names the file.
Result<void> write_attempts(const std::filesystem::path& folder, const AttemptsStudy& study, const AttemptRows& rows);
/// DIR/attempts.csv, a row a (floor, light, seed, sort of attempt, what came of it).
Result<void> write_attempts_csv(const std::filesystem::path& folder, const AttemptRows& rows);

}  // namespace weft::evaluate::floor
