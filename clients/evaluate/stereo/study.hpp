#pragma once
#include <filesystem>
#include <functional>
#include <vector>

#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

struct StereoOptions {
  std::filesystem::path folder;  ///< the recording
  std::filesystem::path truth;   ///< empty: as its layout has it
  /// Holds the rates, each taking so-manieth pairs; empty: every pair, and where a recording is EuRoC's, every second
  /// and every fourth as well.
  std::vector<std::size_t> every;
  bool is_quick = false;  ///< every pair alone
  bool is_json = false;
  std::filesystem::path out;
};

namespace stereo {

/// Studies how well a recorded pair of cameras is followed, and matched densely, beside OpenCV on the same images
/// (docs/results/stereo.md). Prints a table; writes stereo.json, .csv and .png. Goes on where it was stopped, rate by
/// rate. Errors of the recording, and of the folder.
Result<Ended> study_stereo(const StereoOptions& options, const Surroundings& around,
                           const std::function<double()>& processor_s);

}  // namespace stereo
}  // namespace weft::evaluate
