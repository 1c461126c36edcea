#pragma once
#include <functional>
#include <optional>
#include <string>

#include "clients/evaluate/stereo/recording.hpp"

namespace weft::evaluate::stereo {

/// Holds how the product's dense disparity compares to OpenCV's semi-global matcher over a recording.
struct DenseRow {
  std::size_t pairs = 0;
  std::size_t refused = 0;  ///< of them, by ours
  double ours_dense = 0.0;  ///< share of pixels that have a disparity
  double baseline_dense = 0.0;
  double within_1px = 0.0;  ///< share of what both tell
  double ours_ms = 0.0;     ///< of the processor, a pair
  double baseline_ms = 0.0;
};

struct Matching {
  std::size_t every = 8;  ///< matches each so-manieth pair
  std::function<double()> processor_s;
  std::function<void(const std::string&)> warn;
  std::function<bool()> asked_to_stop;
};
/// Matches the pairs of a recording, rectified, both ways. None: stopped. Errors of the recording.
Result<std::optional<DenseRow>> match_densely(const Recording& recording, const Matching& matching);

}  // namespace weft::evaluate::stereo
