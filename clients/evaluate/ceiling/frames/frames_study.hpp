#pragma once
#include <filesystem>

#include "clients/evaluate/surroundings.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

struct CeilingFramesOptions {
  std::filesystem::path folder;  ///< frames_*.raw.gz, golden_*.txt, ceiling.toml
  bool json = false;             ///< one line instead of a table
};

namespace ceiling {

/// Studies how well the method sees a recording of a ceiling (docs/ceiling-study.md). Prints a table, or one line of
/// JSON: frames, lost, rms_heights, rms_fitted_heights, yaw_deg, tilt_deg, wrong_pairs. Errors of `read_recording`
/// and `measure_frames`.
Result<Ended> study_frames(const CeilingFramesOptions& options, const Surroundings& around);

}  // namespace ceiling
}  // namespace weft::evaluate
