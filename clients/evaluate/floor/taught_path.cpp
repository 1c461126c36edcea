#include "clients/evaluate/floor/taught_path.hpp"

#include <algorithm>
#include <cmath>

namespace weft::evaluate::floor {
namespace {

constexpr double kLeastStepM = 0.005;  // closer samples, as standing still gives, make no piece with a direction

}  // namespace

TaughtPath::TaughtPath(const Trace& taught) {
  for (const Moment& moment : taught.moments) {
    const Pose2& pose = moment.site_from_robot;
    const double step = poses_.empty() ? 0.0 : (pose.translation() - poses_.back().translation()).norm();
    if (!poses_.empty() && step < kLeastStepM) continue;
    along_.push_back(along_.empty() ? 0.0 : along_.back() + step);
    poses_.push_back(pose);
  }
}

TaughtPath::Nearest TaughtPath::nearest(const Pose2& site_from_robot, double along_m, double reach_m) const {
  Nearest best;
  double best_m = 1e18;
  const auto from = std::lower_bound(along_.begin(), along_.end(), along_m - reach_m);
  std::size_t i = static_cast<std::size_t>(from - along_.begin());
  i = std::min(i > 0 ? i - 1 : 0, poses_.size() < 2 ? 0 : poses_.size() - 2);
  for (; i + 1 < poses_.size() && along_[i] <= along_m + reach_m; ++i) {
    const Eigen::Vector2d a = poses_[i].translation();
    const Eigen::Vector2d chord = poses_[i + 1].translation() - a;
    const Eigen::Vector2d to_robot = site_from_robot.translation() - a;
    const double share = std::clamp(to_robot.dot(chord) / chord.squaredNorm(), 0.0, 1.0);
    const double away_m = (to_robot - share * chord).norm();
    if (away_m >= best_m) continue;
    best_m = away_m;
    const double turned = wrap_angle(poses_[i + 1].heading - poses_[i].heading);
    const double side = chord.x() * to_robot.y() - chord.y() * to_robot.x();
    best.along_m = along_[i] + share * chord.norm();
    best.lateral_m = std::copysign(away_m, side);
    best.heading_rad = wrap_angle(site_from_robot.heading - (poses_[i].heading + share * turned));
  }
  return best;
}

TaughtPath::Nearest TaughtPath::nearest(const Pose2& site_from_robot) const {
  return nearest(site_from_robot, 0.5 * length_m(), length_m());
}

}  // namespace weft::evaluate::floor
