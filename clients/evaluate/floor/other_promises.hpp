#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "clients/evaluate/floor/attempts/attempt_rows.hpp"
#include "clients/evaluate/floor/bounds.hpp"
#include "clients/evaluate/floor/relocalise/trial_rows.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// Judges that no attempt is wrong, of at least 100,000, at least half of which have no right answer.
Judged judge_attempts(const AttemptRows& rows);
/// Judges that a robot without a seed finds itself within 3 m, of at least 1,000 trials; floors that repeat are left
/// out, but for wrong ones.
Judged judge_trials(const TrialRows& rows);

/// Judges what is promised of the method and other commands measure, from what they left in `folder`: attempts.json
/// and relocalise.json. A file that is missing, or of another software, site or photographs, counts as not measured.
/// corrupt: a file is none of theirs.
Result<std::vector<Judged>> judge_others(const std::filesystem::path& folder, const Study& study);

}  // namespace weft::evaluate::floor
