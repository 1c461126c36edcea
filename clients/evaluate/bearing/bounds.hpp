#pragma once
#include <string>
#include <vector>

#include "clients/evaluate/bearing/rows.hpp"

namespace weft::evaluate::bearing {

/// What is promised of a trial: the error after so many loops, its median and its worst over the seeds.
struct Bound {
  const char* trial = "";
  std::size_t loops = 1;
  const char* paper = "";  ///< Krajnik et al. 2018
  double median = 0.0;
  double worst = 0.0;
};
const std::vector<Bound>& bounds();
/// "oval, after 2 loops".
std::string name_of(const Bound& bound);

struct Judged {
  const Bound* bound = nullptr;
  std::size_t seeds = 0;
  double median = Score::kNothing;
  double worst = Score::kNothing;  ///< NaN: one has not come so far
  bool met = false;
};
std::vector<Judged> judge(const Rows& rows, Seeds seeds);

/// Errors of all seeds after so many loops; NaN: not come so far.
std::vector<double> errors_after(const Rows& rows, Seeds seeds, const std::string& trial, std::size_t loops);

/// NaN, which stands for not having come so far, is the largest; of nothing NaN.
double median_of(std::vector<double> values);

/// Two tables: the bounds, and each trial with what ended it, l and the model's band.
std::string tables_of(const Rows& rows, Seeds seeds);

}  // namespace weft::evaluate::bearing
