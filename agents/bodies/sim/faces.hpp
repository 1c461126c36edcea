#pragma once
#include <cstdint>

/// Describes the looks of boxes' faces. Plain types only, as in floor/kernels.hpp, where the loop over them is
/// chosen.
namespace weft::agents::sim {

enum class FaceLook : std::uint8_t { rack, plain, wall, pillar };

/// Keeps what was looked at last, which neighbouring pixels mostly share. Changes no result.
struct FaceMemo {
  /// Holds the corners of a cell of noise, and the cell's place as whole numbers.
  struct Cell {
    double x = 0.5, y = 0.5;
    std::int64_t salt = 0;
    double corners[4] = {};
  };
  Cell dirt[3];  ///< by size
  /// Holds a rack's load by its place, and its grey level.
  struct Load {
    double along = 0.5, shelf = 0.5;
    std::int64_t salt = 0;
    double grey = 0.0;
  } load;
};

/// Asks for grey levels, as albedo, of places on one face: `along_m` from the face's middle, `up_m` above the floor;
/// details finer than `pixel_m` are left out.
struct FaceJob {
  FaceLook look = FaceLook::plain;
  std::int64_t salt = 0;  ///< of the face: its loads and dirt
  const double* along_m = nullptr;
  const double* up_m = nullptr;
  const double* pixel_m = nullptr;
  int count = 0;
  FaceMemo* memo = nullptr;
  float* out = nullptr;
};

}  // namespace weft::agents::sim
