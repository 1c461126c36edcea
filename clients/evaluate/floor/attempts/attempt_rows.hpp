#pragma once
#include <filesystem>
#include <map>
#include <optional>

#include "clients/evaluate/floor/attempts/tally.hpp"
#include "clients/evaluate/floor/rows.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// Names the study that a folder of attempts belongs to.
struct AttemptsStudy {
  Study study;
  std::size_t attempts_a_row = 0;
};
/// Holds what came of the attempts, by row. `part` of the key: the light.
using AttemptRows = std::map<RowKey, Tally>;

/// Reads DIR/attempts.json; without the file there are no rows. conflict: it is another study's; corrupt: it is none.
Result<AttemptRows> read_attempts(const std::filesystem::path& folder, const AttemptsStudy& study);
/// Returns of which study DIR/attempts.json is; none: there is no such file. corrupt: it is none.
Result<std::optional<AttemptsStudy>> attempts_study_in(const std::filesystem::path& folder);
/// Writes DIR/attempts.json, whole or not at all. unavailable: names the file.
Result<void> write_attempts(const std::filesystem::path& folder, const AttemptsStudy& study, const AttemptRows& rows);
/// Writes DIR/attempts.csv, a row a (floor, light, seed, sort of attempt, what came of it).
Result<void> write_attempts_csv(const std::filesystem::path& folder, const AttemptRows& rows);

}  // namespace weft::evaluate::floor
