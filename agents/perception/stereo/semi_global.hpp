#pragma once
#include <cstdint>

/// Matches one row of a rectified pair after the other by semi-global matching (Hirschmueller 2008), in two builds:
/// one for any x86-64 and one for AVX2, chosen at run time. Both give the same numbers. Plain types only: a file
/// built for AVX2 must not share inline code with the others.
namespace weft::agents::semi_global {

inline constexpr int kLanes = 32;             ///< costs of a pixel lie in whole vectors of as many disparities
inline constexpr int kMostDisparities = 128;  ///< a multiple of 16
inline constexpr int kCensusPlanes = 6;       ///< of four bits of a pixel's census each
inline constexpr int kMostCensus = 4 * kCensusPlanes;
inline constexpr int kPaths = 4;  ///< along the row from both ends, and down to it along both diagonals
/// Bounds the large penalty, so that the sum of all paths fits into eight bits.
inline constexpr int kMostPenalty = 255 / kPaths - kMostCensus;

/// Returns how many bytes the costs of a pixel take: the disparities, rounded up to whole vectors.
constexpr int padded(int disparities) {
  return (disparities + kLanes - 1) / kLanes * kLanes;
}

/// Describes one row that is matched, and what paths bring to it. `costs` stands for width x padded(disparities).
struct Row {
  int width = 0;
  int disparities = 0;
  std::uint8_t small_penalty = 0;  ///< on a disparity that changes by one, P1
  std::uint8_t large_penalty = 0;  ///< by more, P2
  /// Hold the census of the left image's pixels, and of the right image's from right to left: planes of `plane_bytes`
  /// each. Beyond the right image's left rim kMostDisparities more can be read: what a pixel that would lie there is
  /// compared with, so that paths take no disparity for worse; none that ends there is chosen.
  const std::uint8_t* left = nullptr;
  const std::uint8_t* right_reversed = nullptr;
  int plane_bytes = 0;
  /// Hold the costs of the paths down both diagonals as they leave the row above, each with its least a pixel;
  /// replaced by this row's. Zero above the first row. One pixel beyond the last can be read in those from the right.
  std::uint8_t* from_left = nullptr;
  std::uint8_t* from_left_least = nullptr;
  std::uint8_t* from_right = nullptr;
  std::uint8_t* from_right_least = nullptr;
  std::uint8_t* costs = nullptr;  ///< room for the row's own
  std::uint8_t* sums = nullptr;   ///< room for the sum of its paths
  /// Holds by the least sum up to which another sum is too near to it: a disparity further than one from the best
  /// that is as cheap makes the pixel ambiguous.
  const std::uint8_t* too_near = nullptr;
  std::int16_t* best = nullptr;        ///< out: the left pixel's disparity in sixteenths; kAmbiguous
  std::uint8_t* best_right = nullptr;  ///< out: the right pixel's best disparity
};
inline constexpr std::int16_t kAmbiguous = -1;

using MatchRow = void (*)(const Row& row);
/// Returns the fastest that this machine can run.
MatchRow match_row();

namespace plain {
void match_row(const Row& row);
}
namespace avx2 {
void match_row(const Row& row);
}

}  // namespace weft::agents::semi_global
