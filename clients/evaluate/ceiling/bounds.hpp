#pragma once
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "clients/evaluate/ceiling/score.hpp"
#include "clients/evaluate/surroundings.hpp"

namespace weft::evaluate::ceiling {

/// Bounds one number of one trial, or of all trials together.
struct Bound {
  enum class Sense {
    at_most,   ///< median and worst over the seeds
    at_least,  ///< likewise
    between,   ///< the mean over the seeds and all trials that have it, from `median` to `worst`
    none       ///< the sum over the seeds is nought; of `all_trials` with at least `median` counted in `of`
  };
  int row = 0;  ///< of the acceptance table (docs/ceiling-study.md)
  const char* measure = "";
  const char* unit = "";
  const char* trial = "";           ///< empty: all trials that have the value
  std::vector<std::string> values;  ///< by name; of `none` their sum
  Sense sense = Sense::at_most;
  double median = 0.0;
  double worst = Score::kNothing;    ///< not a number: only the median is bounded
  const char* baseline = "";         ///< a value of the same trial; empty: none
  std::vector<std::string> of = {};  ///< of `none`: values that count what could have been wrong
  int digits = 1;
};
const std::vector<Bound>& bounds();

/// Tells what came of a bound.
enum class Verdict { met, missed, not_measured, not_refined, too_few };
const char* to_string(Verdict verdict);

struct Judged {
  const Bound* bound = nullptr;
  std::size_t seeds = 0;
  double median = Score::kNothing;  ///< of `none` the sum, of `between` the mean
  double worst = Score::kNothing;   ///< of `none` how many could have been wrong, of `between` as the mean
  double baseline = Score::kNothing;
  Verdict verdict = Verdict::not_measured;
};

/// Judges what those seeds have come to (`frames` has its own, the line twice as many) by the bounds of some rows of
/// the table; empty: of all.
std::vector<Judged> judge(const Rows& rows, Seeds seeds, const std::set<int>& asked_rows = {});

/// Returns whether one that was measured does not hold: what was not measured, or of too few, is none of them.
bool is_any_missed(const std::vector<Judged>& all);

/// Returns the seeds that a trial is driven with.
Seeds seeds_of(const std::string& trial, Seeds asked);

/// Returns the table: what is asked, what came of it, the baseline beside it.
std::string table_of(const std::vector<Judged>& all);

}  // namespace weft::evaluate::ceiling
