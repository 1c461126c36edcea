#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>

namespace weft {

/// Tells by which model a lens bends rays. Stored in contents, so values are frozen.
enum class LensModel : std::uint8_t {
  radtan = 0,       ///< radial-tangential (Brown), OpenCV's order k1 k2 p1 p2 k3
  equidistant = 1,  ///< Kannala & Brandt 2006 with four coefficients, OpenCV's fisheye: k1 k2 k3 k4
  rational = 2,  ///< radtan whose radial part is divided by 1 + k4 r^2 + k5 r^4 + k6 r^6, as OpenCV and ROS have it
};
const char* to_string(LensModel lens);

/// Describes a camera's lens; refers to the camera's own coefficients.
struct Lens {
  LensModel model;
  const std::array<double, 5>& distortion;  ///< in the model's order; what it does not have is 0
  const std::array<double, 3>& divisor;     ///< k4 k5 k6 of a rational lens
};

/// Bounds how far from the axis, in radians, a ray is seen: at a right angle to it there is no normalised point.
inline constexpr double kWidestRay = 1.5;

/// Returns where a ray through `normalised` (x / z, y / z) lands, in focal lengths from the optical centre.
Eigen::Vector2d bend(const Lens& lens, const Eigen::Vector2d& normalised);

/// Inverts `bend` by Newton's method, with an error below 1e-10 wherever the lens bends one way
/// (core/camera/lens_check.hpp); puts rays beyond `kWidestRay` of an equidistant lens there.
Eigen::Vector2d unbend(const Lens& lens, const Eigen::Vector2d& bent);

}  // namespace weft
