#pragma once
#include <optional>
#include <string>
#include <vector>

#include "agents/perception/camera_model.hpp"
#include "agents/perception/motion.hpp"
#include "agents/perception/view.hpp"
#include "core/result.hpp"

namespace weft::agents {

struct SitePoint {
  double x = 0.0;
  double y = 0.0;
  bool operator==(const SitePoint&) const = default;
};

/// One tick of a body's sensors.
struct Sample {
  std::uint64_t frame = 0;
  SensorTime time{};
  std::optional<View> view;  ///< none: the frame was dropped
  Motion motion;             ///< since the last sample
  bool hand = false;         ///< someone else drives (teaching): `motion.command` is his
  bool hand_done = false;    ///< the hand has reached the end of what it was asked to drive
};

/// What an agent drives. Time is the body's: `step` brings the next sample, driving with `command` until then.
class Body {
 public:
  virtual ~Body() = default;
  /// unavailable: the sensor or recording is over or broken; the message says where. The agent then stands.
  /// corrupt: the same, and what it gave until then was damaged in part.
  virtual Result<Sample> step(const Twist& command) = 0;
  /// Simulated bodies: a clumsy hand drives this polyline (site frame, metres) from where the robot stands.
  /// refused: this body has no such hand; invalid: fewer than two points, too far away, through a rack.
  virtual Result<void> drive_by_hand(const std::vector<SitePoint>& along) = 0;
  virtual void stop_hand() = 0;
  /// The next images of that camera (`View::camera`) are to be taken so, as near to it as the camera can; it does as
  /// it likes again when it has not been told for two seconds of the body's time. refused: this body, or this camera,
  /// cannot be told; not_found: there is no such camera.
  virtual Result<void> expose(const std::string& camera, const Exposure& exposure);
  /// As given to the agent; a simulated body's true one differs.
  virtual std::vector<CameraModel> cameras() const = 0;
  virtual std::string kind() const = 0;
};

inline Result<void> Body::expose(const std::string& camera, const Exposure&) {
  return fail(ErrorCode::refused, "body " + kind() + " cannot be told how its camera " + camera + " exposes");
}

}  // namespace weft::agents
