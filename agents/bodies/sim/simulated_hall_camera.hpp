#pragma once
#include <memory>
#include <string>

#include "agents/bodies/sim/hall/hall_camera.hpp"
#include "agents/bodies/sim/simulated_camera.hpp"

namespace weft::agents::sim {

/// Describes a camera of a robot that looks around in a hall.
struct HallCameraSetup {
  std::string name;    ///< of the sensor
  CameraModel given;   ///< as agents are told it
  CameraModel actual;  ///< as it is
  ExposureSetup exposure;
  bool meters_as_seen = false;  ///< exposes for the image as it came out: a lamp in it is white and no more
  HallCameraOptions options;
};

/// Makes a camera that exposes itself, whose shutter may roll and whose exposure blurs.
std::unique_ptr<SimulatedCamera> make_hall_camera(const Site& site, const HallCameraSetup& setup,
                                                  std::shared_ptr<const Hall> hall, Random light);

}  // namespace weft::agents::sim
