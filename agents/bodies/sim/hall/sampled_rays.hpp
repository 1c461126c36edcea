#pragma once
#include <array>
#include <cstddef>
#include <vector>

#include "agents/perception/camera_model.hpp"

namespace weft::agents::sim {

inline constexpr std::size_t kHallSamples = 4;
inline constexpr int kHallBand = 4;  ///< rows of an image that are taken together

/// Finds the pixel of the i-th ray of a block of 4 x 4 pixels.
struct BlockPixels {
  int columns;
  std::size_t at(std::size_t block, std::size_t i) const;
};

struct PixelRays;

/// Holds the rays of each of the looks through an image's pixels, in blocks of 4 x 4 pixels.
struct SampledRays {
  /// Darkens corners by `vignetting`. `widest_rad`, of a lens whose image is round: no light comes from further off
  /// the axis; 0: it fills the sensor.
  SampledRays(const CameraModel& camera, double vignetting, double widest_rad);

  std::array<std::vector<float>, kHallSamples> x, y;  ///< normalised, without distortion
  std::vector<float> off_axis2, length;               ///< of the ray through a pixel's middle
  std::vector<float> vignette;                        ///< share of light that arrives; 0 beyond the lens's circle

 private:
  void add_looks(const PixelRays& rays, const CameraModel& camera, std::size_t pixel);
};

}  // namespace weft::agents::sim
