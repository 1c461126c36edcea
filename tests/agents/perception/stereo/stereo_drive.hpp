#pragma once
// A short drive through a room, for tests of what follows it.
#include <chrono>
#include <utility>

#include "agents/perception/stereo/stereo_odometry.hpp"
#include "tests/support/stereo_room.hpp"

namespace weft::test {

inline constexpr Duration kBetween = std::chrono::milliseconds(100);

/// Drives through a room: 4 cm and 0.02 rad a view.
class Drive {
 public:
  explicit Drive(StereoRoom room, agents::StereoOdometryConfig config = {})
      : room_(std::move(room)), odometry(std::move(*agents::StereoOdometry::make(config, sensor))) {}

  const Pose2 step = se2_exp({0.04, 0.004, 0.02});
  const agents::Sensor sensor = stereo_sensor(320, 240, 208.0, 0.12);

  agents::StereoPair next_pair() {
    StereoShot shot;
    shot.seed = seed_++;
    agents::StereoPair pair = room_.pair(sensor, lift(at_), shot);
    at_ = at_ * step;
    return pair;
  }
  agents::OrUnseen<agents::SeenMotion> see(const agents::StereoPair& pair,
                                           const agents::StereoOdometry::IsPossible& is_possible = {}) {
    return odometry.observe(state, pair, kBetween, is_possible);
  }
  agents::OrUnseen<agents::SeenMotion> see_next() { return see(next_pair()); }

 private:
  StereoRoom room_;
  Pose2 at_{1.0, 0.0, -0.1};
  std::uint64_t seed_ = 1;

 public:
  agents::StereoOdometry odometry;
  agents::StereoOdometry::State state;
};

/// Returns what is assumed of a robot of which nobody knows anything: it stands, and that is uncertain.
inline Metric3 standing() {
  Metric3 assumed;
  assumed.covariance = Matrix6d(0.01 * Matrix6d::Identity());
  return assumed;
}

/// Returns by how many metres a step is off.
inline double off_m(const Pose2& driven, const agents::SeenMotion& seen) {
  return se3_log(lift(driven).inverse() * seen.previous_from_current.a_from_b).head<3>().norm();
}

}  // namespace weft::test
