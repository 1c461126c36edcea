#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "core/geometry/pose3.hpp"
#include "storage/formats/not_understood.hpp"

namespace weft::formats {

/// Holds poses over time in the file's own frame; times strictly increase.
struct Trajectory {
  struct Sample {
    double time_s = 0.0;
    Pose3 frame_from_body;
  };
  std::vector<Sample> samples;
};

/// Reads TUM's format: "t x y z qx qy qz qw" a line, seconds and metres; '#' begins a comment.
/// A second pose of the same time, which recordings have, is left out and listed.
/// invalid, with file and line: another count of numbers, one that is not finite, a time beyond 1e10 s (it is counted
/// in nanoseconds, say) or before the last one, a quaternion that is not unit within 1e-3 (taken ones are
/// normalised).
Result<Read<Trajectory>> read_tum(std::string_view text, std::string_view file);

/// Reads EuRoC's state_groundtruth_estimate0/data.csv: nanoseconds, position, quaternion w x y z; lists the columns
/// after them (velocity, biases) as not understood. Errors as for TUM.
Result<Read<Trajectory>> read_euroc_csv(std::string_view text, std::string_view file);

/// Reads back bit for bit.
std::string tum_text(const Trajectory& trajectory);

}  // namespace weft::formats
