#pragma once
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "tests/agents/methods/tiny/grid_filter.hpp"

namespace weft::agents::tiny {

/// Finds its own way as methods of free space do: by its particles, which go on from chart to chart, along edges in
/// either direction, and by shortcuts. What it is told and asked is noted for tests, which answer for what it sees.
class Roamer : public GridFilter {
 public:
  struct Noted {
    int steered_in_chart = 0;
    int steered_without_chart = 0;
    Pose2 centre_from_robot;  ///< as steering was told last
    std::optional<Ahead> ahead;
    int begun = 0;
    int carried = 0;
    std::vector<LostFor> lost;
    std::vector<std::pair<Pose2, Pose2>> asked_clear;  ///< centre_from_a, a_from_b
    std::string_view stops_for;                        ///< empty: nothing stands in its way
    std::function<bool(const Pose2& centre_from_a, const Pose2& a_from_b)> is_clear;
  };

  static constexpr std::string_view name = "roamer";
  static constexpr bool is_posterior = true;
  static constexpr bool drives_both_ways = true;

  explicit Roamer(std::shared_ptr<Noted> noted = std::make_shared<Noted>()) : noted_(std::move(noted)) {}

  Belief begin(const Chart& chart, const Estimate& seed) const {
    ++noted_->begun;
    return GridFilter::begin(chart, seed);
  }
  Belief carried(const Chart& chart, const Estimate& seed, Belief before) const {
    ++noted_->carried;
    if (before.particles.empty()) return GridFilter::begin(chart, seed);
    for (const auto& [id, centre_from_place] : chart.centre_from_places) {
      if (id != seed.place) continue;
      const Pose2 old_from_robot = middle(before.particles);
      const Pose2 new_from_old = planar(compose(centre_from_place, seed.place_from_robot)) * old_from_robot.inverse();
      for (Particle& particle : before.particles)
        particle.centre_from_robot = new_from_old * particle.centre_from_robot;
    }
    return before;
  }

  Steering steer(Odometry&, const Around<Roamer>* around, const Ahead& ahead) const {
    ++(around == nullptr ? noted_->steered_without_chart : noted_->steered_in_chart);
    noted_->ahead = ahead;
    if (around == nullptr) return Twist{};
    noted_->centre_from_robot = around->centre_from_robot;
    if (!noted_->stops_for.empty()) return tl::unexpected(Stop{noted_->stops_for});
    return towards(carrot(ahead.robot_from_path), ahead);
  }

  bool is_clear(const Chart&, const Pose2& centre_from_a, const Pose2& a_from_b) const {
    noted_->asked_clear.emplace_back(centre_from_a, a_from_b);
    return noted_->is_clear && noted_->is_clear(centre_from_a, a_from_b);
  }

  /// Returns what the contents say, if they say anything: they see better than odometry.
  Relation registered(const Content& a, const Content& b, const Relation& a_from_b) const {
    const OrRefusal<Related> related = relate(a, b, a_from_b);
    return related ? related->a_from_b : a_from_b;
  }

  std::optional<Twist> recover(Odometry&, const LostFor& lost) const {
    noted_->lost.push_back(lost);
    if (lost.turned_rad > 4.0 * M_PI) return std::nullopt;
    return Twist{0.0, 0.6};
  }

 private:
  static Pose2 middle(const std::vector<Particle>& particles) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    const Pose2 first = particles.front().centre_from_robot;
    for (const Particle& one : particles)
      mean += se2_log(first.inverse() * one.centre_from_robot) / static_cast<double>(particles.size());
    return first * se2_exp(mean);
  }

  /// Returns the first point of the way on, half a metre beyond where the robot is on it.
  static Eigen::Vector2d carrot(const std::vector<Pose2>& robot_from_path) {
    constexpr double reach_m = 0.5;
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < robot_from_path.size(); ++i)
      if (robot_from_path[i].translation().norm() < robot_from_path[nearest].translation().norm()) nearest = i;
    for (std::size_t i = nearest + 1; i < robot_from_path.size(); ++i)
      if (robot_from_path[i].translation().norm() > reach_m) return robot_from_path[i].translation();
    return robot_from_path.back().translation();
  }
  static Twist towards(const Eigen::Vector2d& carrot, const Ahead& ahead) {
    constexpr double there_m = 0.1;
    constexpr double turn_first_rad = 0.7;
    if (ahead.robot_from_path.back().translation().norm() < there_m) return {};
    const double aside_rad = std::atan2(carrot.y(), carrot.x());
    const double turn_rad_s = std::clamp(1.5 * aside_rad, -0.8, 0.8);
    if (std::abs(aside_rad) > turn_first_rad) return {0.0, turn_rad_s};
    return {std::min(ahead.speed_limit_m_s, std::max(0.08, 0.6 * ahead.to_end_m)), turn_rad_s};
  }

  std::shared_ptr<Noted> noted_;
};

static_assert(SteersItself<Roamer> && CarriesBelief<Roamer> && Clears<Roamer> && Registers<Roamer>);
static_assert(Recovers<Roamer> && weft::agents::is_posterior<Roamer>() && weft::agents::drives_both_ways<Roamer>());
static_assert(!SteersItself<GridFilter> && !CarriesBelief<GridFilter> && !Clears<GridFilter>);

}  // namespace weft::agents::tiny
