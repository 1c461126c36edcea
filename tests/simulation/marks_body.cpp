#include "tests/simulation/marks_body.hpp"

#include <algorithm>
#include <cmath>

namespace weft::simulation {
namespace {

constexpr double kMovingPeriod_s = 0.1;
constexpr double kRestPeriod_s = 2.0;
constexpr double kDarkens = 2e-4;  // at a frame of a robot that drives itself: once in some ten minutes of driving
constexpr std::size_t kTruthFrames = 4000;

/// Returns where the line leads at first; none when that is ahead.
std::optional<Eigen::Vector2d> off_to_the_side(const Pose2& site_from_robot,
                                               const std::vector<agents::SitePoint>& along) {
  constexpr double lead_m = 0.5;
  constexpr double aside_rad = 1.0;
  for (const agents::SitePoint& point : along) {
    const Eigen::Vector2d there = site_from_robot.inverse() * Eigen::Vector2d(point.x, point.y);
    if (there.norm() < lead_m) continue;
    if (std::abs(std::atan2(there.y(), there.x())) < aside_rad) return std::nullopt;
    return Eigen::Vector2d(point.x, point.y);
  }
  return std::nullopt;
}

}  // namespace

MarksBody::MarksBody(std::shared_ptr<const Site> site, const Pose2& site_from_robot, Random random)
    : site_(std::move(site)),
      random_(random),
      base_({.lag_s = 0.1, .delay_samples = 1, .slip = 0.01, .turn_slip = 0.02, .drift_rad_per_m = 0.005},
            site_from_robot),
      wheel_scale_(random_.uniform(0.97, 1.03)),
      wheel_turn_(random_.uniform(-0.02, 0.02)) {}

Result<agents::Sample> MarksBody::step(const agents::Twist& command) {
  const bool hand = by_hand() || hand_done_;
  const bool is_empty = battery_ && battery_->is_empty();
  const bool is_driven = !hand && !is_empty && !is_stop(safety_);
  const agents::Twist drive = by_hand() ? hand_twist() : is_driven ? command : agents::Twist{};
  // A base that still turns, or has a command under way, does not rest.
  const agents::Twist turning = base_.wheels();
  const bool still = std::abs(turning.linear_m_s) < 1e-3 && std::abs(turning.angular_rad_s) < 1e-3;
  const bool resting = drive == agents::Twist{} && driven_ == agents::Twist{} && still;
  driven_ = drive;
  const double period = resting ? kRestPeriod_s : kMovingPeriod_s;
  base_.drive(is_held_up(drive) ? agents::Twist{0.0, drive.angular_rad_s} : drive, period);

  agents::Sample sample;
  sample.frame = ++frame_;
  sample.time = (time_ += from_seconds(period));
  sample.safety = safety_;
  sample.hand = hand;
  sample.hand_done = hand_done_;
  sample.motion.elapsed = from_seconds(period);
  sample.motion.command = drive;
  const double rolled = base_.wheels().linear_m_s * period;
  if (battery_) {
    battery_->advance(rolled, period, {site_from_robot().x, site_from_robot().y});
    sample.charge = battery_->charge();
  }
  sample.motion.wheels = agents::WheelStep{rolled * wheel_scale_, base_.last_step().heading + wheel_turn_ * rolled};
  // Lamps fail, mostly for longer than a robot may drive blind.
  const bool may_darken = !hand && !resting && time_ >= dark_until_;
  if (may_darken && random_.chance(kDarkens)) dark_until_ = time_ + from_seconds(random_.uniform(2.0, 30.0));
  if (!random_.chance(0.005) && time_ >= dark_until_) sample.views.push_back(look());
  truth_.emplace(frame_, site_from_robot());
  if (truth_.size() > kTruthFrames) truth_.erase(truth_.begin());
  return sample;
}

/// Returns whether the robot would touch the crate, were it driven like that a little longer.
bool MarksBody::is_held_up(const agents::Twist& drive) const {
  constexpr double touches_m = 0.6;
  constexpr double soon_s = 0.2;
  if (!crate_in_site_) return false;
  const Pose2 soon = site_from_robot() * Pose2{soon_s * drive.linear_m_s, 0.0, 0.0};
  const double away_m = (soon.translation() - *crate_in_site_).norm();
  return away_m < touches_m && away_m < (site_from_robot().translation() - *crate_in_site_).norm();
}

agents::View MarksBody::look() {
  const double luck = random_.uniform();
  Pose2 from = site_from_robot();
  if (luck < 0.003) from = site_->pose(random_.uniform(0.0, site_->length_m()), {});  // looks like somewhere else
  agents::Marks marks;
  if (luck < 0.99) marks = read_marks(*site_, from, random_);
  return {frame_, time_, "marks", "marks", std::move(marks)};
}

Result<void> MarksBody::drive_by_hand(const std::vector<agents::SitePoint>& along) {
  if (along.size() < 2) return fail(ErrorCode::invalid, "hand: a line needs two points or more");
  const Eigen::Vector2d here = site_from_robot().translation();
  const double away = std::hypot(along.front().x - here.x(), along.front().y - here.y());
  if (away > 1.0) {
    return fail(ErrorCode::invalid,
                "hand: the line starts " + std::to_string(away) + " m from the robot, at most 1 m");
  }
  hand_ = along;
  hand_at_ = 0;
  hand_done_ = false;
  hand_turns_to_ = off_to_the_side(site_from_robot(), along);
  return {};
}

agents::Twist MarksBody::hand_twist() {
  if (!hand_turns_to_) return follow_hand();
  constexpr double ahead_rad = 0.2;
  constexpr double turn_rad_s = 0.8;
  const Eigen::Vector2d target = site_from_robot().inverse() * *hand_turns_to_;
  const double bearing = std::atan2(target.y(), target.x());
  if (std::abs(bearing) > ahead_rad) return {0.0, bearing > 0.0 ? turn_rad_s : -turn_rad_s};
  hand_turns_to_.reset();
  return follow_hand();
}

/// Looks 0.6 m ahead on the line and wanders a few centimetres about it.
agents::Twist MarksBody::follow_hand() {
  const Pose2 robot_from_site = site_from_robot().inverse();
  const auto local = [&](std::size_t i) { return robot_from_site * Eigen::Vector2d(hand_[i].x, hand_[i].y); };
  while (hand_at_ + 1 < hand_.size() && (local(hand_at_).norm() < 0.6 || local(hand_at_).x() < 0.0)) ++hand_at_;
  const Eigen::Vector2d target = local(hand_at_);
  if (hand_at_ + 1 == hand_.size() && (target.x() < 0.05 || target.norm() < 0.08)) {
    hand_.clear();
    hand_done_ = true;
    return {};
  }
  wander_ = std::clamp(wander_ + random_.normal(0.0, 0.004), -0.06, 0.06);
  const double bearing = std::atan2(target.y() + wander_, std::max(0.05, target.x()));
  const double speed = hand_at_ + 1 == hand_.size() ? std::clamp(target.norm(), 0.1, 0.5) : 0.55;
  return {speed, std::clamp(1.8 * bearing, -1.0, 1.0)};
}

std::optional<Pose2> MarksBody::at_frame(std::uint64_t frame) const {
  const auto found = truth_.find(frame);
  return found == truth_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace weft::simulation
