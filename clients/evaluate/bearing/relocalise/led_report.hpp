#pragma once
#include <string>
#include <vector>

#include "clients/evaluate/bearing/relocalise/kinds.hpp"
#include "clients/evaluate/bearing/relocalise/led_rows.hpp"

namespace weft::evaluate::bearing {

/// Sums up a kind's trials in a light.
struct LedGroup {
  const LookAlikes* kind = nullptr;
  std::string light;
  std::size_t seeds = 0;
  std::size_t right = 0;
  std::size_t wrong = 0;
  std::size_t refused = 0;
  double after_m = 0.0;  ///< led, the median of those that found themselves
  bool met = false;      ///< none wrong, and the share that is promised found itself; or not judged

  std::size_t trials() const { return right + wrong + refused; }
};
/// Returns those groups of which there are trials, in the order of look_alikes() and other_lights().
std::vector<LedGroup> judge(const LedRows& rows);

/// Returns a row a group, and one of all that are judged together; then a row for the pairs of each kind of loads.
std::string tables_of(const LedRows& rows);

}  // namespace weft::evaluate::bearing
