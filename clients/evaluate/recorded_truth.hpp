#pragma once
#include <filesystem>
#include <optional>

#include "core/result.hpp"
#include "storage/formats/trajectory.hpp"

namespace weft::evaluate {

/// Reads where a recording's body truly was: of the file that is given, else of groundtruth_tum.txt, groundtruth.txt
/// or mav0/state_groundtruth_estimate0/data.csv in its folder; none: there is none of them. Files that end in .csv
/// are EuRoC's, others TUM's. not_found: the file that is given is missing; the formats' errors.
Result<std::optional<formats::Trajectory>> recorded_truth(const std::filesystem::path& recording,
                                                          const std::filesystem::path& given);

}  // namespace weft::evaluate
