#pragma once
#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/pose3.hpp"

namespace weft::evaluate::registration {

/// Holds what one way of registering answers.
struct Answer {
  std::string name;
  std::optional<Pose3> a_from_b;
  std::string refused;  ///< why there is no answer, or why it is not to be trusted; empty: neither
  double ms = 0.0;      ///< of the processor
};

/// Holds how the answers of several ways stand against the truth, or against GICP's where nobody knows it.
struct PairReport {
  struct Row {
    Answer answer;
    double metres = std::numeric_limits<double>::quiet_NaN();  ///< off; NaN: there is no answer
    double degrees = std::numeric_limits<double>::quiet_NaN();
  };
  std::vector<Row> rows;                ///< the first is ours
  std::array<std::size_t, 2> points{};  ///< of a and b
  bool knows_truth = false;
  bool is_met = false;  ///< ours within 0.02 m and 0.4 degrees of the truth, or within 0.03 m of GICP
};

/// Compares the answers, ours first and GICP's second.
PairReport compared(const std::vector<Answer>& answers, const std::optional<Pose3>& truth,
                    const std::array<std::size_t, 2>& points);

std::string table_of(const PairReport& report);
/// Returns one line of JSON: points, against, rows, asked, is_met; null where there is no number, reason or bound.
std::string json_of(const PairReport& report);

}  // namespace weft::evaluate::registration
