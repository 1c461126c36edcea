#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agents/bodies/sim/floor/source.hpp"
#include "agents/bodies/sim/hall/textures.hpp"
#include "agents/bodies/sim/site.hpp"
#include "agents/perception/rig.hpp"
#include "agents/perception/view.hpp"
#include "core/random.hpp"

namespace weft::agents::sim {

/// Describes the time and place at which an image is taken.
struct Moment {
  /// Returns where a camera with this mount is so many seconds from now, all that shakes it included.
  std::function<Pose3(const Pose3& robot_from_camera, double from_now_s)> site_from_camera;
  Pose2 site_from_robot;
  double time_s = 0.0;
  std::vector<double> waited_s = {};  ///< of each of the site's movers, until then; empty: none has
  double brightness = 1.0;            ///< of what the sensor makes of light, as it drifts
  std::uint64_t noise_seed = 0;
};

/// Is what a view holds.
using Seen = decltype(View::data);

/// Is a camera, or a pair, that a body sees with.
class SimulatedCamera {
 public:
  virtual ~SimulatedCamera() = default;
  /// Returns the sensor as agents are told it; the true one differs.
  virtual const Sensor& sensor() const = 0;
  /// Begins another run: each lamp is as bright as `random` makes it.
  virtual void light_up(Random random) = 0;
  virtual Seen look(const Moment& moment) = 0;
  /// Returns the exposure of the image looked at last; none: not known.
  virtual std::optional<Exposure> exposed() const { return std::nullopt; }
  /// Sets the exposure from the next image on. False: it cannot be told.
  virtual bool expose(const Exposure&) { return false; }
};

/// Describes the owner of a camera; the calibration's name and errors follow from it.
struct CameraOwner {
  std::string robot;
  std::uint64_t day = 0;
  Random calibration;  ///< of that day: each is another attempt to measure the camera
  Random camera;       ///< the glass and the screws, the same every day
};

std::unique_ptr<SimulatedCamera> make_floor_camera(const Site& site, const CameraOwner& owner,
                                                   std::shared_ptr<const FloorSource> floor, Random light);
std::unique_ptr<SimulatedCamera> make_forward_camera(const Site& site, const CameraOwner& owner,
                                                     const std::shared_ptr<const FloorSource>& floor,
                                                     const Photographed& photographed, Random light);
std::unique_ptr<SimulatedCamera> make_ceiling_camera(const Site& site, const CameraOwner& owner,
                                                     const std::shared_ptr<const FloorSource>& floor,
                                                     const Photographed& photographed, Random light);

std::unique_ptr<SimulatedCamera> make_stereo_camera(const Site& site, const CameraOwner& owner,
                                                    const std::shared_ptr<const FloorSource>& floor,
                                                    const Photographed& photographed, Random light);

}  // namespace weft::agents::sim
