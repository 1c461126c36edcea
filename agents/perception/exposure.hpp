#pragma once
#include "agents/perception/view.hpp"

namespace weft::agents {

struct ExposureConfig {
  double noise_grey = 4.0;    ///< [0.5, 50] differences of grey levels up to it tell nothing, unamplified
  double white_grey = 250.0;  ///< [128, 255] from there on it is not known how bright something is
  double hidden_slope = 1.5;  ///< [0.1, 10] with f < 1 times the light, f^hidden_slope of the white pixels stay white
  double followed = 0.5;      ///< [0.05, 1] of the power of 2 that is missing, an image
  double most_blur_px = 1.0;  ///< [0.1, 50] by which an image may move while it is taken; the rest is amplified
  double longest_time_s = 0.02;  ///< [1e-4, 0.5]
};

/// Returns the factor by which the next image is to have more light than this one so that it shows most for matching;
/// 1: it is well as it is. An image shows as much as gradients tell above the noise, on a scale of logarithms (Shim,
/// Lee & Kweon 2014, "Auto-adjusting camera exposure for outdoor robotics using gradient information", eq. 1), each
/// part of it the less the more of it is white. Unlike there, other exposures are predicted as a sensor makes them,
/// in proportion up to white (docs/decisions/028-exposure-for-matching.md). `gain`: how amplified the image is, 1 if
/// nobody knows. Within [1/4, 4]. The image is whole (`is_whole`).
double exposure_factor(const Image& image, double gain, const ExposureConfig& config);

/// Returns an exposure of `factor` times the light of `taken`, for an image that moves by `moves_px_s`.
Exposure brightened(const Exposure& taken, double factor, double moves_px_s, const ExposureConfig& config);

}  // namespace weft::agents
