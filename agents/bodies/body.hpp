#pragma once
#include <string>
#include <vector>

#include "agents/perception/rig.hpp"
#include "agents/perception/sample.hpp"
#include "core/result.hpp"

namespace weft::agents {

struct SitePoint {
  double x = 0.0;
  double y = 0.0;
  bool operator==(const SitePoint&) const = default;
};

/// Is the body that an agent drives. Time is the body's: `step` brings the next sample, driving with `command` until
/// then.
class Body {
 public:
  virtual ~Body() = default;
  /// Returns the next sample; after an error the agent stands, and the message says where. unavailable: the sensor or
  /// recording is over or broken. corrupt: the same, and what it gave until then was damaged in part. exhausted: a
  /// simulated body cannot write its true pose, as its disk is full.
  virtual Result<Sample> step(const Twist& command) = 0;
  /// Lets a clumsy hand drive a simulated body along this polyline (site frame, metres) from where the robot stands.
  /// refused: this body has no such hand; invalid: fewer than two points, too far away, through a rack.
  virtual Result<void> drive_by_hand(const std::vector<SitePoint>& along) = 0;
  virtual void stop_hand() = 0;
  /// Takes the next images of that sensor so, as near to it as the sensor can; it does as it likes again when it has
  /// not been told for two seconds of the body's time. refused: this body, or this sensor, cannot be told; not_found:
  /// there is no such sensor.
  virtual Result<void> expose(const std::string& sensor, const Exposure& exposure);
  /// Returns what it looks with, as given to the agent; a simulated body's true rig differs.
  virtual Rig rig() const = 0;
  virtual std::string kind() const = 0;
};

inline Result<void> Body::expose(const std::string& sensor, const Exposure&) {
  return fail(ErrorCode::refused, "body " + kind() + " cannot be told how its sensor " + sensor + " exposes");
}

}  // namespace weft::agents
