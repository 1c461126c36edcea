#include <cmath>
#include <numbers>

#include "agents/bodies/sim/calibration.hpp"
#include "agents/bodies/sim/simulated_hall_camera.hpp"

namespace weft::agents::sim {
namespace {

constexpr std::uint64_t kErrorsUp = 3;  // stream of a robot's camera errors: others than those of its forward camera

/// Returns the faces of a robot's post, in its frame.
std::vector<Quad> faces_of(const Mast& mast) {
  Quad look;
  look.grey = static_cast<float>(mast.grey);
  std::vector<Quad> faces;
  add_closed_box({{mast.forward_m, mast.left_m, 0.0}, 0.0, mast.side_m, mast.side_m, mast.height_m}, look, faces);
  return faces;
}

}  // namespace

Pose3 upward_mount(const CeilingCameraSetup& setup, bool is_true) {
  const double forward = setup.tilt_forward_rad + (is_true ? setup.tilt_error_forward_rad : 0.0);
  const double left = setup.tilt_left_rad + (is_true ? setup.tilt_error_left_rad : 0.0);
  Pose3 mount =
      downward_mount(setup.forward_m, setup.left_m, setup.height_m, -std::numbers::pi / 2, 0.0, setup.yaw_rad);
  const Eigen::Vector3d lean(-left, forward, 0.0);
  if (const double angle = lean.norm(); angle > 0.0)
    mount.rotation = (Eigen::Quaterniond(Eigen::AngleAxisd(angle, lean / angle)) * mount.rotation).normalized();
  return mount;
}

std::unique_ptr<SimulatedCamera> make_ceiling_camera(const Site& site, const CameraOwner& owner,
                                                     const std::shared_ptr<const FloorSource>& floor,
                                                     const Photographed& photographed, Random light) {
  const CeilingCameraSetup& up = site.ceiling_camera;
  HallCameraSetup setup;
  setup.name = "ceiling";
  setup.given = given_ceiling_camera_from(up, site.disturbances, owner.robot);
  CameraModel leant = setup.given;
  leant.robot_from_camera = upward_mount(up, true);
  Random errors = owner.camera;
  setup.actual = true_camera_from(leant, site.disturbances, site.change.sinks_m, errors.fork(kErrorsUp));
  setup.exposure = static_cast<const ExposureSetup&>(up);
  setup.meters_as_seen = true;
  setup.options = {.vignetting = site.disturbances.vignetting,
                   .widest_rad = up.lens == LensModel::equidistant ? up.widest_rad : 0.0,
                   .bloom = up.bloom};
  if (up.mast) setup.options.carried = faces_of(*up.mast);
  return make_hall_camera(site, setup, std::make_shared<const Hall>(site, *floor, photographed), light);
}

}  // namespace weft::agents::sim
