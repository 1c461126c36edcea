#pragma once
#include <string>
#include <vector>

#include "clients/evaluate/floor/relocalise/trial_rows.hpp"

namespace weft::evaluate::floor {

/// Sets what is promised: so many percent of the median and of the worst seed find themselves.
inline constexpr double kFoundMedianPercent = 99.0;
inline constexpr double kFoundWorstPercent = 97.0;

/// Sums up what was pushed one way on a floor, in a light.
struct TrialGroup {
  std::string kind;
  std::string part;
  Along along = Along::forwards;
  std::vector<double> missed_percent;  ///< a number a seed
  std::vector<Trial> trials;           ///< of all seeds
  bool met = false;  ///< 99 % found, of the worst seed 97 %, none wrong; of floors that repeat: none wrong
};
std::vector<TrialGroup> judge(const TrialRows& rows);

/// Returns a row a group: the share that found itself, median and worst over the seeds, against what is promised.
std::string tables_of(const TrialRows& rows);

}  // namespace weft::evaluate::floor
