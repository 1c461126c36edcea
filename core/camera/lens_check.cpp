#include "core/camera/lens_check.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "core/camera/number_text.hpp"

namespace weft {
namespace {

constexpr int kDirections = 16;
constexpr int kStrides = 32;  // from the centre to the furthest corner
constexpr double kLargest = 1e6;

std::string too_large(double coefficient) {
  return "distortion coefficient " + number_text(coefficient) + " is no number in [-1e+06, 1e+06]";
}

/// Returns how far the furthest corner lies from the optical centre, in focal lengths.
double reach_of(const CameraCalibration& camera) {
  return std::hypot(std::max(camera.cx, camera.width - camera.cx) / camera.fx,
                    std::max(camera.cy, camera.height - camera.cy) / camera.fy);
}

/// Finds where along one direction from the optical centre rays land nearer to it than those before, in pixels; none:
/// not before they leave the image.
std::optional<double> fold_px(const CameraCalibration& camera, const Eigen::Vector2d& direction) {
  const Lens lens{camera.lens, camera.distortion, camera.divisor};
  const double stride = std::atan(reach_of(camera)) / kStrides;
  Eigen::Vector2d last = Eigen::Vector2d::Zero();
  for (double angle = stride; angle < kWidestRay; angle += stride) {
    const Eigen::Vector2d bent = bend(lens, std::tan(angle) * direction);
    const Eigen::Vector2d from_centre(camera.fx * bent.x(), camera.fy * bent.y());
    if (!(bent.norm() > last.norm())) return Eigen::Vector2d(camera.fx * last.x(), camera.fy * last.y()).norm();
    const Eigen::Vector2d pixel = from_centre + Eigen::Vector2d(camera.cx, camera.cy);
    if (pixel.x() < 0.0 || pixel.y() < 0.0 || pixel.x() > camera.width || pixel.y() > camera.height) break;
    last = bent;
  }
  return std::nullopt;
}

}  // namespace

Result<void> check_lens(const CameraCalibration& camera) {
  const auto is_wrong = [](double k) { return !(std::abs(k) <= kLargest); };
  for (const double k : camera.distortion)
    if (is_wrong(k)) return fail(ErrorCode::invalid, too_large(k));
  for (const double k : camera.divisor)
    if (is_wrong(k)) return fail(ErrorCode::invalid, too_large(k));
  std::optional<double> nearest;
  for (int i = 0; i < kDirections; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / kDirections;
    const std::optional<double> fold = fold_px(camera, {std::cos(turn), std::sin(turn)});
    if (fold.has_value()) nearest = std::min(*fold, nearest.value_or(*fold));
  }
  if (!nearest.has_value()) return {};
  return fail(ErrorCode::invalid,
              "the distortion is not monotone over the image: " + std::to_string(std::lround(*nearest)) +
                  " px from the optical centre the radius ceases to grow, it must as far as the "
                  "corners; calibrate anew, with the board in the corners too");
}

}  // namespace weft
