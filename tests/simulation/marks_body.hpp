#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "agents/bodies/battery.hpp"
#include "agents/bodies/body.hpp"
#include "core/random.hpp"
#include "tests/simulation/site.hpp"
#include "tests/support/unicycle.hpp"

namespace weft::simulation {

/// Simulates a robot on a site that sees marks: noisy, sometimes nothing, sometimes the marks of quite another spot.
class MarksBody : public agents::Body {
 public:
  MarksBody(std::shared_ptr<const Site> site, const Pose2& site_from_robot, Random random);

  Result<agents::Sample> step(const agents::Twist& command) override;
  Result<void> drive_by_hand(const std::vector<agents::SitePoint>& along) override;
  void stop_hand() override {
    hand_.clear();
    hand_done_ = false;
    hand_turns_to_.reset();
  }
  agents::Rig rig() const override { return {}; }
  std::string kind() const override { return "marks"; }

  /// Returns the true pose, for the invariants alone.
  const Pose2& site_from_robot() const { return base_.world_from_robot(); }
  double true_speed_m_s() const { return base_.wheels().linear_m_s; }
  /// Has its base stop by itself, or go on.
  void press(Safety safety) { safety_ = safety; }
  /// Puts a crate on the floor, which it is not driven into: its base stands before that and says nothing.
  void put_crate(const Eigen::Vector2d& crate_in_site) { crate_in_site_ = crate_in_site; }
  void take_crate() { crate_in_site_.reset(); }
  /// Gives it a battery; without one it says nothing of its charge.
  void equip(agents::Battery battery) { battery_ = std::move(battery); }
  bool by_hand() const { return !hand_.empty(); }
  /// Returns where the robot was at a frame of the last few minutes.
  std::optional<Pose2> at_frame(std::uint64_t frame) const;

 private:
  agents::Twist hand_twist();
  agents::Twist follow_hand();
  agents::View look();
  bool is_held_up(const agents::Twist& drive) const;

  std::shared_ptr<const Site> site_;
  Random random_;
  test::Unicycle base_;
  double wheel_scale_;
  double wheel_turn_;
  std::uint64_t frame_ = 0;
  SensorTime time_{};
  SensorTime dark_until_{};
  std::vector<agents::SitePoint> hand_;
  std::size_t hand_at_ = 0;
  bool hand_done_ = false;
  std::optional<Eigen::Vector2d> hand_turns_to_;  ///< on the spot, before it goes along the line
  double wander_ = 0.0;
  agents::Twist driven_;  ///< the last command
  std::optional<agents::Battery> battery_;
  std::optional<Eigen::Vector2d> crate_in_site_;
  Safety safety_ = Safety::ok;
  std::map<std::uint64_t, Pose2> truth_;
};

}  // namespace weft::simulation
