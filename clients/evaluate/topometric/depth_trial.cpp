#include "clients/evaluate/topometric/depth_trial.hpp"

#include <cmath>
#include <utility>
#include <variant>

#include "agents/perception/stereo/disparity.hpp"
#include "agents/perception/stereo/rectifier.hpp"
#include "clients/evaluate/floor/scenario.hpp"
#include "clients/evaluate/topometric/spread.hpp"
#include "clients/evaluate/topometric/taught.hpp"
#include "clients/evaluate/topometric/true_hall.hpp"

namespace weft::evaluate::topometric {
namespace {

using namespace agents;

constexpr int kPairEvery = 5;
constexpr int kPixelEvery = 3;  // of rows and columns
constexpr double kWrongPx = 1.0;
constexpr double kLedM = 16.0;
constexpr double kLedInHallM = 8.0;

struct DenseErrors {
  double pixels = 0.0;
  double returned = 0.0;
  double wrong = 0.0;
};

void judge_pair(const DisparityMap& map, const StereoRig& rig, const Pose2& site_from_robot, const TrueHall& hall,
                DenseErrors& errors) {
  const Pose3 site_from_camera = lift(site_from_robot) * rig.robot_from_camera;
  for (int row = 0; row < map.height; row += kPixelEvery) {
    for (int column = 0; column < map.width; column += kPixelEvery) {
      errors.pixels += 1.0;
      const std::optional<double> said_px = map.at(column, row);
      if (!said_px) continue;
      const Eigen::Vector3d in_camera((column - rig.cx) / rig.focal_px, (row - rig.cy) / rig.focal_px, 1.0);
      const double depth_m = hall.meets_after(site_from_camera.translation, site_from_camera.rotation * in_camera);
      errors.returned += 1.0;
      errors.wrong += std::abs(*said_px - rig.disparity_px(depth_m)) > kWrongPx ? 1.0 : 0.0;
    }
  }
}

sim::Site with_known_mount(sim::Site site) {
  site.disturbances.mount_error_m = 0.0;
  site.disturbances.mount_error_rad = 0.0;
  return site;
}

/// Leads the pair along a line. None: stopped.
Result<std::optional<DenseErrors>> lead(const sim::Site& site, const std::vector<SitePoint>& line,
                                        const Driven& driven) {
  sim::SimBodyConfig config;
  config.site = with_known_mount(on_beginning(site, "r1", line));
  config.robot = "r1";
  config.seed = driven.seed;
  const auto body = sim::make_sim_body(config);
  if (!body) return fail(body.error());
  const auto rectifier = Rectifier::make((*body)->rig().sensors.front());
  if (!rectifier) return fail(rectifier.error());
  const TopometricConfig settings;
  const TrueHall hall(site, 0);
  if (const Result<void> begun = (*body)->drive_by_hand(line); !begun) return fail(begun.error());
  DenseErrors errors;
  for (int i = 0;; ++i) {
    if (driven.asked_to_stop()) return std::optional<DenseErrors>();
    const Result<Sample> sample = (*body)->step({});
    if (!sample) return fail(sample.error());
    if (sample->hand_done) return std::optional(errors);
    if (i % kPairEvery != 0 || sample->views.empty()) continue;
    const auto* const pair = std::get_if<StereoPair>(&sample->views.front().data);
    if (pair == nullptr) continue;
    if (const auto map = match_disparity(settings.disparity, rectifier->rectified(*pair)))
      judge_pair(*map, rectifier->rig(), (*body)->site_from_robot(), hall, errors);
  }
}

}  // namespace

Result<std::optional<Measured>> measure_depth(const Scenes& scenes, const Driven& driven) {
  const auto office = lead(scenes.level11.site, floor::stretch(scenes.level11.line, 0.0, kLedM), driven);
  if (!office) return fail(office.error());
  if (!*office) return std::optional<Measured>();
  const auto hall = lead(scenes.hall.site, floor::stretch(scenes.hall.line, 0.0, kLedInHallM), driven);
  if (!hall) return fail(hall.error());
  if (!*hall) return std::optional<Measured>();
  Measured measured;
  measured.score.values = {{"dense_wrong_percent", percent_of((*office)->wrong, (*office)->returned)},
                           {"dense_percent", percent_of((*office)->returned, (*office)->pixels)},
                           {"hall_dense_percent", percent_of((*hall)->returned, (*hall)->pixels)},
                           {"hall_wrong_percent", percent_of((*hall)->wrong, (*hall)->returned)}};
  return std::optional(std::move(measured));
}

}  // namespace weft::evaluate::topometric
