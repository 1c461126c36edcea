#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <optional>
#include <string_view>
#include <vector>

#include "core/geometry/pose3.hpp"
#include "core/result.hpp"

namespace weft::evaluate::registration {

/// Reads the points of a PCD or PLY, those left out that are not finite. not_found, and the formats' errors.
Result<std::vector<Eigen::Vector3f>> read_points(const std::filesystem::path& file);

/// Reads a pose as the upper rows of a 4 x 4 matrix, numbers apart by blanks. invalid: fewer than 12 numbers, or a
/// rotation that is none within 1e-3; names `what`.
Result<Pose3> parse_matrix(std::string_view text, std::string_view what);

/// Reads "X,Y,Z,HEADING" in metres and radians. invalid: says what is wrong.
Result<Pose3> parse_guess(std::string_view text);

}  // namespace weft::evaluate::registration
