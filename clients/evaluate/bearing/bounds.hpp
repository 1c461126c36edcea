#pragma once
#include <string>
#include <vector>

#include "clients/evaluate/bearing/rows.hpp"

namespace weft::evaluate::bearing {

/// Bounds what is promised of a trial: its median and its worst over the seeds.
struct Bound {
  enum class Of {
    error_m,         ///< after so many loops
    band_m,          ///< by which the first loop lies beside the model
    drift_m_a_loop,  ///< how fast it goes astray: at least so fast
    loops_driven     ///< before it was lost
  };
  const char* trial = "";
  Of of = Of::error_m;
  std::size_t loops = 1;
  const char* paper = "";  ///< Krajnik et al. 2018
  double median = 0.0;
  double worst = 0.0;

  /// Returns whether a value has to be at least as large: what the paper shows to fail is to fail here.
  bool is_least() const { return of == Of::drift_m_a_loop; }
};
const std::vector<Bound>& bounds();
/// Returns the bound in words: "oval, after 2 loops".
std::string name_of(const Bound& bound);
/// Returns the number that the bound is about. NaN: the robot has not come so far.
double value_of(const Bound& bound, const Score& score);

struct Judged {
  const Bound* bound = nullptr;
  std::size_t seeds = 0;
  double median = Score::kNothing;
  double worst =
      Score::kNothing;  ///< NaN: one has not come so far; of what is promised to be at least so much, the least
  bool met = false;
};
std::vector<Judged> judge(const Rows& rows, Seeds seeds);
/// Returns whether one that was measured does not hold.
bool is_any_missed(const std::vector<Judged>& all);

/// Returns the errors of all seeds after so many loops; NaN: not come so far.
std::vector<double> errors_after(const Rows& rows, Seeds seeds, const std::string& trial, std::size_t loops);

/// Returns the median. NaN, which stands for not having come so far, counts as the largest; of nothing NaN.
double median_of(std::vector<double> values);

/// Returns two tables: the bounds, and each trial with what ended it, l and the model's band.
std::string tables_of(const Rows& rows, Seeds seeds);

}  // namespace weft::evaluate::bearing
