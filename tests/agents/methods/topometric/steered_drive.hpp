#pragma once
#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <string_view>
#include <vector>

#include "agents/control/grid/costmap.hpp"
#include "tests/agents/methods/topometric/made_site.hpp"

namespace weft::agents {

/// Drives a robot by `steer` along a path of a site, in a chart that was made of another state of the same site. It
/// obeys commands a little late, and knows where it is.
class SteeredDrive {
 public:
  SteeredDrive(const MadeSite& now, const TopometricChart& chart, const Pose2& site_from_chart)
      : site_(now), chart_(chart), site_from_chart_(site_from_chart), method_(made_method()), random_(31) {
    odometry_.costmap.emplace(CostmapConfig{});
    odometry_.time = SensorTime{from_seconds(1.0)};
  }
  SteeredDrive(const MadeSite&& temporary, const TopometricChart& chart, const Pose2& site_from_chart) = delete;

  struct Settings {
    double limit_m_s = 0.5;
    double aside_m = 0.0;
    double for_s = 60.0;
    double stops_for_s = 2.0;  ///< stood so long for one reason, it is over
    double dark_from_s = 1e9;  ///< it sees nothing any more
  };
  struct Outcome {
    Pose2 end;                 ///< in the site
    double off_m = 0.0;        ///< from the end of the path
    std::string_view stopped;  ///< why it stands in the end; empty: it does not
    double least_room_m = 1e9;
    double fastest_m_s = 0.0;
    double most_aside_m = 0.0;  ///< from the path
    double took_s = 0.0;
    double steered_first_rad = 0.0;  ///< turned before it drove
    bool has_been_pending = false;
    double turned_lost_rad = 0.0;  ///< on the spot, without a way
    bool has_driven_lost = false;
  };

  /// Drives until it stands at the end of the path or is stopped for long.
  Outcome along(const std::vector<Pose2>& site_from_path, const Pose2& site_from_robot, const Settings& settings) {
    Outcome out;
    truth_ = site_from_robot;
    std::deque<Twist> late(2);  // 0.2 s
    Twist moves;
    double stood_s = 0.0;
    bool has_driven = false;
    for (double t = 0.0; t < settings.for_s; t += kPeriodS) {
      if (t < settings.dark_from_s) look();
      const Steering steering = steer_once(site_from_path, moves.linear_m_s, settings);
      out.stopped = steering ? std::string_view{} : steering.error().reason;
      out.has_been_pending |= odometry_.plan.mode == PlanMode::switch_pending;
      const Twist command = steering.value_or(Twist{});
      if (odometry_.plan.mode == PlanMode::lost) {
        out.turned_lost_rad += std::abs(command.angular_rad_s) * kPeriodS;
        out.has_driven_lost |= command.linear_m_s != 0.0;
      }
      late.push_back(command);
      moves = late.front();
      late.pop_front();
      const Pose2 step = se2_exp({moves.linear_m_s * kPeriodS, 0.0, moves.angular_rad_s * kPeriodS});
      truth_ = truth_ * step;
      odometry_.odometry_from_robot = odometry_.odometry_from_robot * lift(step);
      odometry_.time += from_seconds(kPeriodS);
      if (t >= settings.dark_from_s) odometry_.blind_m += step.translation().norm();
      has_driven = has_driven || moves.linear_m_s > 0.02;
      if (!has_driven) out.steered_first_rad += std::abs(step.heading);
      out.least_room_m = std::min(out.least_room_m, site_.room_m(truth_.translation()));
      out.fastest_m_s = std::max(out.fastest_m_s, moves.linear_m_s);
      out.most_aside_m = std::max(out.most_aside_m, aside_m(site_from_path));
      out.took_s = t;
      const bool stands = command == Twist{} && moves == Twist{};
      stood_s = stands ? stood_s + kPeriodS : 0.0;
      if (stood_s >= settings.stops_for_s) break;
    }
    out.end = truth_;
    out.off_m = (truth_.translation() - site_from_path.back().translation()).norm();
    return out;
  }

  Topometric::Odometry& odometry() { return odometry_; }
  const Topometric& method() const { return method_; }

 private:
  static constexpr double kPeriodS = 0.1;

  void look() {
    const Scan scan = site_.scan_from(truth_, random_);
    odometry_.costmap->take(project(odometry_.odometry_from_robot), scan, odometry_.time);
    odometry_.scan = scan;
  }
  Steering steer_once(const std::vector<Pose2>& site_from_path, double speed_m_s, const Settings& settings) {
    Ahead ahead;
    for (const Pose2& pose : site_from_path) ahead.robot_from_path.push_back(truth_.inverse() * pose);
    ahead.to_end_m = (site_from_path.back().translation() - truth_.translation()).norm();
    ahead.end_is_goal = true;
    ahead.speed_limit_m_s = settings.limit_m_s;
    ahead.speed_m_s = speed_m_s;
    ahead.aside_m = settings.aside_m;
    ahead.elapsed = from_seconds(kPeriodS);
    const TopometricBelief belief;
    const Around<Topometric> around{&chart_, &belief, site_from_chart_.inverse() * truth_};
    return method_.steer(odometry_, &around, ahead);
  }
  double aside_m(const std::vector<Pose2>& path) const {
    double nearest = 1e9;
    for (std::size_t i = 1; i < path.size(); ++i) {
      const Eigen::Vector2d from = path[i - 1].translation();
      const Eigen::Vector2d along = path[i].translation() - from;
      const double share = std::clamp((truth_.translation() - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (truth_.translation() - from - share * along).norm());
    }
    return nearest;
  }

  const MadeSite& site_;
  const TopometricChart& chart_;
  Pose2 site_from_chart_;
  Topometric method_;
  Random random_;
  Pose2 truth_;
  Topometric::Odometry odometry_;
};

}  // namespace weft::agents
