#include "clients/evaluate/floor/other_promises.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

#include "clients/evaluate/floor/relocalise/trial_report.hpp"
#include "clients/evaluate/floor/scenario.hpp"

namespace weft::evaluate::floor {
namespace {

constexpr std::size_t kAttempts = 100'000;
constexpr std::size_t kTrials = 1'000;

/// Returns whether both studies measured the same but for the line, of which other commands drive their own.
bool is_of_same(const Study& theirs, const Study& ours) {
  return theirs.software == ours.software && theirs.site_sha256 == ours.site_sha256 &&
         theirs.floors_sha256 == ours.floors_sha256;
}

bool has_no_right_answer(const std::string& sort) {
  using namespace attempted;
  static const std::vector<std::string> some = {kElsewhere,    kLookAlike,     kElsewhereGuided,
                                                kWrongGuess,   kMirrored,      kSeekingOther,
                                                kTrackingLost, kStitchingLost, kOtherFloor};
  return std::find(some.begin(), some.end(), sort) != some.end();
}

double wrong_of(const Tally& tally) {
  return static_cast<double>(tally.wrong());
}

}  // namespace

Judged judge_attempts(const AttemptRows& rows) {
  static const Bound bound{"wrong fixes or stitches, at least half without a right answer", "", "-"};
  Judged judged;
  judged.bound = &bound;
  judged.command = "floor-attempts";
  std::map<GroupKey, std::vector<double>> groups;
  std::size_t attempts = 0;
  std::size_t unanswerable = 0;
  double wrong = 0.0;
  for (const auto& [key, tally] : rows) {
    groups[{key.kind, key.part}].push_back(wrong_of(tally));
    attempts += tally.attempts();
    wrong += wrong_of(tally);
    for (const auto& [sort, outcomes] : tally.sorts)
      unanswerable += has_no_right_answer(sort) ? outcomes.attempts() : 0;
  }
  for (const auto& [key, values] : groups) {
    const MedianWorst of = median_worst(values);
    judged.groups.push_back({key.first, key.second, values.size(), 0.0, of.median, of.worst, of.worst == 0.0});
  }
  if (groups.empty()) return judged;
  judged.median = judged.worst = wrong;
  judged.of = attempts;
  judged.met = wrong == 0.0 && attempts >= kAttempts && 2 * unanswerable >= attempts;
  return judged;
}

Judged judge_trials(const TrialRows& rows) {
  static const Bound bound{"relocalisation without a seed within 3 m",
                           "%",
                           "-",
                           Bound::Of::repeat,
                           nullptr,
                           kFoundMedianPercent,
                           kFoundWorstPercent};
  Judged judged;
  judged.bound = &bound;
  judged.command = "floor-relocalise";
  std::size_t trials = 0;
  for (const TrialGroup& group : judge(rows)) {
    const MedianWorst missed = median_worst(group.missed_percent);
    judged.groups.push_back({group.kind, group.part + ", pushed " + name_of(group.along), group.missed_percent.size(),
                             0.0, 100.0 - missed.median, 100.0 - missed.worst, group.met});
    if (repeats_itself(group.kind)) continue;
    trials += group.trials.size();
    judged.median = std::fmin(judged.median, 100.0 - missed.median);
    judged.worst = std::fmin(judged.worst, 100.0 - missed.worst);
  }
  if (judged.groups.empty()) return judged;
  judged.of = trials;
  judged.met = trials >= kTrials &&
               std::all_of(judged.groups.begin(), judged.groups.end(), [](const Group& group) { return group.met; });
  return judged;
}

Result<std::vector<Judged>> judge_others(const std::filesystem::path& folder, const Study& study) {
  AttemptRows attempts;
  TrialRows trials;
  const Result<std::optional<AttemptsStudy>> of_attempts = attempts_study_in(folder);
  if (!of_attempts) return fail(of_attempts.error());
  if (*of_attempts && is_of_same((*of_attempts)->study, study)) {
    Result<AttemptRows> rows = read_attempts(folder, **of_attempts);
    if (!rows) return fail(rows.error());
    attempts = std::move(*rows);
  }
  const Result<std::optional<Study>> of_trials = trials_study_in(folder);
  if (!of_trials) return fail(of_trials.error());
  if (*of_trials && is_of_same(**of_trials, study)) {
    Result<TrialRows> rows = read_trials(folder, **of_trials);
    if (!rows) return fail(rows.error());
    trials = std::move(*rows);
  }
  return std::vector<Judged>{judge_attempts(attempts), judge_trials(trials)};
}

}  // namespace weft::evaluate::floor
