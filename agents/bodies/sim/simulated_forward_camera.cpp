#include "agents/bodies/sim/calibration.hpp"
#include "agents/bodies/sim/simulated_hall_camera.hpp"

namespace weft::agents::sim {
namespace {

/// Returns the camera as agents are told it: a focal length from a data sheet and where it was screwed on. Nobody has
/// measured its lens, on any day.
CameraModel given_camera(const ForwardCameraSetup& setup, const CameraOwner& owner) {
  CameraModel camera;
  camera.id = owner.robot + "/forward";
  camera.width = setup.width;
  camera.height = setup.height;
  camera.fx = camera.fy = setup.focal_px;
  camera.cx = (setup.width - 1) / 2.0;
  camera.cy = (setup.height - 1) / 2.0;
  camera.robot_from_camera = downward_mount(setup.forward_m, setup.left_m, setup.height_m, setup.pitch_rad, 0.0, 0.0);
  return camera;
}

CameraModel true_camera(CameraModel camera, const Site& site, const CameraOwner& owner) {
  camera = true_camera_from(camera, site.disturbances, site.change.sinks_m, owner.camera);
  camera.distortion = {site.forward_camera.k1, 0.0, 0.0, 0.0, 0.0};
  return camera;
}

}  // namespace

std::unique_ptr<SimulatedCamera> make_forward_camera(const Site& site, const CameraOwner& owner,
                                                     const std::shared_ptr<const FloorSource>& floor,
                                                     const Photographed& photographed, Random light) {
  HallCameraSetup setup;
  setup.name = "forward";
  setup.given = given_camera(site.forward_camera, owner);
  setup.actual = true_camera(setup.given, site, owner);
  setup.exposure = static_cast<const ExposureSetup&>(site.forward_camera);
  setup.options = {.vignetting = site.disturbances.vignetting, .headlight = site.forward_camera.headlight};
  return make_hall_camera(site, setup, std::make_shared<const Hall>(site, *floor, photographed), light);
}

}  // namespace weft::agents::sim
