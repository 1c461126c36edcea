#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "agents/perception/hamming.hpp"

namespace weft::agents {

/// Names a feature of a place of a run, both by index.
struct RunFeature {
  std::uint32_t place = 0;
  std::uint32_t feature = 0;
  bool operator==(const RunFeature&) const = default;
};

/// Holds which features of a place (`Match::a`) the newest one's (`Match::b`) are taken for.
struct MatchedPlace {
  std::uint32_t place = 0;  ///< index, earlier than the newest one's
  std::vector<Match> matches;
};

/// Follows the corners of a ceiling from place to place of a run: each has one feature of a place at most.
class RunCorners {
 public:
  /// Takes the next place, which has so many features. What is matched first counts first; what is not matched begins
  /// a corner.
  void add(std::size_t features, std::span<const MatchedPlace> matched);

  /// Returns the features of each corner in the order of their places.
  const std::vector<std::vector<RunFeature>>& corners() const { return corners_; }

 private:
  std::vector<std::vector<RunFeature>> corners_;
  std::vector<std::vector<std::uint32_t>> corner_of_;  ///< of each place's features
};

}  // namespace weft::agents
