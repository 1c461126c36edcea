#include "clients/evaluate/ceiling/published_line.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <variant>

#include "agents/perception/lens.hpp"
#include "clients/evaluate/ceiling/published_mosaic.hpp"

namespace weft::evaluate::ceiling {
namespace {

constexpr double kPublishedM_s = 0.4;
constexpr double kWheelRadiusM = 0.05;
constexpr double kGapPx = 10.0;
constexpr double kFasterRad_s = 1.0;

}  // namespace

agents::Twist published_command(double left_px, double track_m) {
  if (std::abs(left_px) <= kGapPx) return {kPublishedM_s, 0.0};
  const double faster_m_s = kFasterRad_s * kWheelRadiusM;
  const double turn_rad_s = faster_m_s / track_m;
  return {kPublishedM_s + 0.5 * faster_m_s, left_px > 0.0 ? -turn_rad_s : turn_rad_s};
}

Result<std::optional<std::vector<BesideLine>>> drive_as_published(const agents::sim::SimBodyConfig& config,
                                                                  double metres,
                                                                  const std::function<bool()>& asked_to_stop) {
  constexpr double most_beside_m = 2.0;
  agents::sim::SimBodyConfig blind_to_truth = config;
  blind_to_truth.truth_path.reset();
  const auto body = agents::sim::make_sim_body(blind_to_truth);
  if (!body) return fail(body.error());
  const agents::CameraModel camera = (*body)->rig().camera();
  const Pose2 site_from_line = (*body)->site_from_robot();
  PublishedMosaic mosaic(camera);
  agents::Twist command;
  std::vector<BesideLine> drive;
  for (double elapsed_s = 0.0; elapsed_s < 3.0 * metres / kPublishedM_s;) {
    if (asked_to_stop()) return std::optional<std::vector<BesideLine>>();
    const Result<agents::Sample> sample = (*body)->step(command);
    if (!sample) return fail(sample.error());
    elapsed_s += seconds(sample->motion.elapsed);
    if (const agents::View* const view = sample->of({}))
      if (const auto* const image = std::get_if<agents::Image>(&view->data)) mosaic.add(*image);
    const double left_px = mosaic.robot_in_start().y() * agents::focal_px(camera);
    command = published_command(left_px, config.site.base.track_m);
    const Pose2 truth = site_from_line.inverse() * (*body)->site_from_robot();
    drive.push_back({truth.x, truth.y});
    if (truth.x >= metres || std::abs(truth.y) > most_beside_m) break;
  }
  return std::optional(std::move(drive));
}

BesideErrors errors_of(const std::vector<BesideLine>& drive) {
  if (drive.empty()) return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  double squares = 0.0;
  double worst = 0.0;
  for (const BesideLine& at : drive) {
    squares += at.left_m * at.left_m;
    worst = std::max(worst, std::abs(at.left_m));
  }
  return {std::sqrt(squares / static_cast<double>(drive.size())), worst};
}

}  // namespace weft::evaluate::ceiling
