#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace weft::evaluate {

/// Holds what a trial with one seed has come to: numbers by name, units in the names.
struct TrialNumbers {
  static constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

  std::map<std::string, double> values;
  /// Returns the number; NaN: the trial has none of that name.
  double value(const std::string& name) const {
    const auto found = values.find(name);
    return found == values.end() ? kNothing : found->second;
  }
};

using TrialKey = std::pair<std::string, std::uint64_t>;  ///< trial, seed
using TrialRows = std::map<TrialKey, TrialNumbers>;

/// Holds lines of points for the pictures, by name.
using ShownLines = std::map<std::string, std::vector<std::array<double, 2>>>;

struct MeasuredTrial {
  TrialNumbers score;
  ShownLines shown;
  std::vector<std::string> said = {};  ///< for people, in words
};

}  // namespace weft::evaluate
