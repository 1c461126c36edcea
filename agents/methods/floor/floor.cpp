#include "agents/methods/floor/floor.hpp"

#include <utility>

#include "agents/perception/lens.hpp"
#include "agents/perception/overlap.hpp"
#include "agents/perception/plane/geometry.hpp"

namespace weft::agents {

static_assert(Method<Floor> && SimulatesRevisits<Floor> && Diagnoses<Floor>);

std::string_view Floor::name_of(SeenBy by) {
  switch (by) {
    case SeenBy::corners:
      return "corners";
    case SeenBy::grey_values:
      return "grey_values";
    case SeenBy::features:
      return "features";
    case SeenBy::nothing:
      break;
  }
  return "nothing";
}

Floor::Floor(const FloorConfig& config, const CameraModel& camera, BirdsEye birds_eye)
    : config_(config), camera_(camera), birds_eye_(std::move(birds_eye)), calibration_errors_(config, camera) {}

Result<Floor> Floor::make(const FloorConfig& config, const CameraModel& camera) {
  if (const Result<void> sound = check(camera); !sound) return fail(sound.error());
  if (const std::vector<std::string> issues = check(config); !issues.empty()) {
    std::string all;
    for (const std::string& issue : issues) all += (all.empty() ? "" : "; ") + issue;
    return fail(ErrorCode::invalid, all);
  }
  if (area(footprint(camera, Attitude{}, config.far_m)) < 0.05)
    return fail(ErrorCode::invalid, "camera \"" + camera.id +
                                        "\" sees less than 0.05 m2 of floor within floor.far_m = " +
                                        std::to_string(config.far_m) + " m; correct its mount");
  return Floor(informed(config, camera.sigma), camera,
               BirdsEye(camera, {config.far_m, config.half_width_m, config.metres_per_pixel}));
}

}  // namespace weft::agents
