#include "agents/methods/floor/diagnostics.hpp"

#include <cmath>

#include "agents/methods/floor/floor.hpp"

namespace weft::agents {
namespace {

std::string height_notice(double offset_m, std::string_view compared_with) {
  return "its camera stands " + std::to_string(std::lround(1000.0 * std::abs(offset_m))) + " mm " +
         (offset_m < 0.0 ? "lower" : "higher") + " than " + std::string(compared_with) +
         ": look at load, tyres and mount, or calibrate it (weft calibrate mount)";
}

}  // namespace

// Load, tyres and a mount that has moved look the same. Against itself no second calibration plays a part.
const std::array<WatchedDiagnostic, 1> Floor::watched = {{{kHeightOffset,
                                                           {kHeightNoticedM, 0.005},
                                                           {0.005, 0.003},
                                                           height_notice,
                                                           "its camera stands as high as its places say again"}}};

std::vector<Diagnostic> Floor::diagnose(const Odometry& odometry) const {
  const std::optional<MountReport> report = odometry.mount ? odometry.mount->report() : std::nullopt;
  if (!report) return {};
  const MountTilt& tilt = report->tilt;
  std::vector<Diagnostic> all = {{"mount_pitch_rad", tilt.pitch_rad, tilt.sigma_rad(), 0.0},
                                 {"mount_roll_rad", tilt.roll_rad, tilt.sigma_rad(), 0.0}};
  if (report->height_by_wheels) all.push_back({"mount_height_share", *report->height_by_wheels, 0.0, 0.0});
  return all;
}

}  // namespace weft::agents
