#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "agents/perception/stereo/stereo_rig.hpp"
#include "agents/perception/stereo/unseen.hpp"
#include "agents/perception/view.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Sets how a rectified pair is matched densely.
struct DisparityConfig {
  int disparities = 64;        ///< a multiple of 16, [16, 128]: 0 .. disparities - 2 are told
  int small_penalty = 7;       ///< [1, 39] on disparities of neighbours that differ by one, in bits of the census
  int large_penalty = 32;      ///< [small_penalty, 39] by more
  double uniqueness = 0.05;    ///< [0, 0.5] by how much the second best must cost more
  double least_texture = 8.0;  ///< [0, 200] RMS of Sobel's horizontal gradient around a pixel
  int least_patch_px = 100;    ///< [0, 100000] smaller patches of one surface are left out
  double patch_step_px = 1.0;  ///< [0, 16] between neighbours of one patch
  // When a pair is refused
  double least_light = 16.0;    ///< [0, 255] grey level that a twentieth of either image is brighter than
  double least_likeness = 0.2;  ///< [0, 1] of the range of grey levels in one image, of the other's
  double least_matched = 0.3;   ///< [0, 1] of the pixels with texture that both images agree on
};
/// Rejects what breaks a bound (invalid, naming it).
Result<void> check(const DisparityConfig& config);

/// Holds the disparity of each pixel of a rectified left image, row by row.
struct DisparityMap {
  static constexpr std::int16_t none = -1;

  int width = 0;
  int height = 0;
  std::vector<std::int16_t> sixteenths;  ///< of a pixel; none: not known

  std::optional<double> at(int column, int row) const {
    const std::int16_t value = sixteenths[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) +
                                          static_cast<std::size_t>(column)];
    return value == none ? std::nullopt : std::optional(value / 16.0);
  }
};
/// Returns the share of pixels that have a disparity.
double density(const DisparityMap& map);

/// Matches a rectified pair: the census of 5x5 neighbours, semi-globally along four paths; what is ambiguous, not
/// seen by the right camera, without texture, or a speckle has no disparity. Both images are whole and of one size,
/// from 16x16 up; `config` is sound. Refuses "too_dark" (both images), "covered" (one image shows far less than the
/// other), "too_near" (much of what has texture lies nearer than is searched; measured: its disparity in the median),
/// "decorrelated" (what has texture is not found in the other image: one is late, or something hides it).
OrUnseen<DisparityMap> match_disparity(const DisparityConfig& config, const StereoPair& rectified);

/// Holds a point that a pair sees.
struct DepthPoint {
  Eigen::Vector3f in_camera;  ///< the rig's left camera; metres
  float depth_sigma_m = 0.0F;
  std::int32_t pixel = 0;  ///< row times width plus column
};
/// Returns the points of every `every`-th column and row that are no further than `range_m`. `disparity_sigma_px` is
/// what a disparity is uncertain by.
std::vector<DepthPoint> points_of(const DisparityMap& map, const StereoRig& rig, double range_m,
                                  double disparity_sigma_px, int every = 1);

}  // namespace weft::agents
