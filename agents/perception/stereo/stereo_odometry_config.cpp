#include "agents/perception/stereo/stereo_odometry_config.hpp"

#include <string>

namespace weft::agents {

Result<void> check(const StereoOdometryConfig& c) {
  const auto wrong = [](const std::string& what) { return fail(ErrorCode::invalid, "stereo odometry: " + what); };
  const auto within = [](double value, double low, double high) { return value >= low && value <= high; };
  if (!within(c.corners, 40, 2000)) return wrong("corners is not within 40..2000");
  if (!within(c.window_px, 7, 31) || c.window_px % 2 == 0) return wrong("window_px is no odd number within 7..31");
  if (!within(c.pyramid_levels, 1, 5)) return wrong("pyramid_levels is not within 1..5");
  if (!within(c.nearest_m, 0.05, 10.0)) return wrong("nearest_m is not within 0.05..10");
  if (!within(static_cast<double>(c.fewest_inliers), 6, 1000)) return wrong("fewest_inliers is not within 6..1000");
  if (!within(c.fewest_inliers_share, 0.0, 1.0)) return wrong("fewest_inliers_share is not within 0..1");
  if (!within(c.least_spread, 0.0, 0.3)) return wrong("least_spread is not within 0..0.3");
  if (!within(c.most_residual_px, 0.1, 10.0)) return wrong("most_residual_px is not within 0.1..10");
  if (!within(c.keyframe_share, 0.1, 0.95)) return wrong("keyframe_share is not within 0.1..0.95");
  if (!within(c.keyframe_rad, 0.01, 2.0)) return wrong("keyframe_rad is not within 0.01..2");
  if (!within(c.keyframe_nearer, 0.01, 1.0)) return wrong("keyframe_nearer is not within 0.01..1");
  if (!within(static_cast<double>(c.patience), 0, 100)) return wrong("patience is not within 0..100");
  return {};
}

}  // namespace weft::agents
