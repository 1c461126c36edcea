#include "agents/agent/blocked_watch.hpp"

#include <chrono>
#include <cmath>

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

/// Bounds from below what counts as asked to drive: creeping up to a goal is slower.
constexpr double kDrives_m_s = 0.05;
constexpr double kTurns_rad_s = 0.1;
/// Bounds from below what counts as moved.
constexpr double kMoved_m = 0.03;
constexpr double kMoved_rad = 0.05;
constexpr Duration kBlockedAfter = 2s;

bool has_moved(const Estimate& from, const Estimate& to) {
  if (from.place != to.place) return true;
  const Pose2 before = planar(from.place_from_robot);
  const Pose2 after = planar(to.place_from_robot);
  return (after.translation() - before.translation()).norm() > kMoved_m ||
         std::abs(wrap_angle(after.heading - before.heading)) > kMoved_rad;
}

}  // namespace

void BlockedWatch::take(const Twist& asked, bool sees_something, const std::optional<Estimate>& estimate,
                        SteadyTime now) {
  const bool drives =
      sees_something || std::abs(asked.linear_m_s) > kDrives_m_s || std::abs(asked.angular_rad_s) > kTurns_rad_s;
  if (!drives || !estimate || !stood_at_ || has_moved(*stood_at_, *estimate)) {
    stood_at_ = drives ? estimate : std::nullopt;
    since_ = now;
    is_blocked_ = false;
    return;
  }
  is_blocked_ = now - since_ >= kBlockedAfter;
}

}  // namespace weft::agents
