#pragma once
#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/result.hpp"

namespace weft::evaluate::heading {

/// Holds two images of a set, and by how much somebody found what they both show to be shifted.
struct KnownShift {
  std::string group;         ///< place or path
  std::size_t a = 0, b = 0;  ///< index into the set's images
  double shift_px = 0.0;     ///< of b's things against a's, right positive
};

struct ShiftedImages {
  std::vector<std::filesystem::path> images;
  std::vector<KnownShift> pairs;
};

/// Reads a folder in one of GRIEF's two layouts (Krajnik et al. 2017):
/// - ground_truth/location_N.txt, a square of whitespace-separated numbers, row i and column j: x_j - x_i in pixels
/// of
///   seasons i and j, with images/SSNN.* (season and location, two digits from 01); every two seasons are a pair;
/// - displacements.txt, a row an image: its number (may be left out), pixels right, pixels down; season_00/ and
///   season_01/ with nine-digit names.
/// not_found: neither, or an image that is missing, by name; invalid: a number or a square that is none, by file and
/// line.
Result<ShiftedImages> read_known_shifts(const std::filesystem::path& folder);

}  // namespace weft::evaluate::heading
