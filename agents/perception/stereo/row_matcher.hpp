#pragma once
#include <array>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "agents/perception/stereo/census.hpp"
#include "agents/perception/stereo/disparity.hpp"
#include "agents/perception/stereo/semi_global.hpp"

namespace weft::agents {

/// Matches a pair row after row, from the top on.
class RowMatcher {
 public:
  /// `pair` is whole; `config` is sound.
  RowMatcher(const DisparityConfig& config, const StereoPair& pair);
  RowMatcher(const RowMatcher&) = delete;
  RowMatcher& operator=(const RowMatcher&) = delete;

  /// Returns the left image's rows around one, with those beyond the rim repeated.
  FiveRows left_rows(int row) const;
  /// Writes the row's disparities: none where it is ambiguous, or the right image says otherwise.
  void match(int row, std::int16_t* best);

 private:
  std::array<std::uint8_t, 256> too_near_;
  semi_global::MatchRow match_;
  cv::Mat left_, right_;  // with rims; the right one from right to left
  std::vector<std::uint8_t> planes_, costs_, least_, best_right_;
  semi_global::Row row_;
};

}  // namespace weft::agents
