#pragma once
#include <utility>

#include "agents/control/spline.hpp"
#include "agents/methods/bearing/bearing.hpp"
#include "clients/evaluate/bearing/course.hpp"

namespace weft::evaluate::bearing {

/// `bearing` with one of its two parts taken away (Krajnik et al. 2018, IV-A): the profile is replayed without
/// looking, or the robot steers by what it sees alone and knows no bends.
class Ablated {
 public:
  static constexpr std::string_view name = agents::Bearing::name;
  static constexpr std::uint32_t content_format = agents::Bearing::content_format;
  using Content = agents::Bearing::Content;
  using Odometry = agents::Bearing::Odometry;
  using Chart = agents::Bearing::Chart;
  using Belief = agents::Bearing::Belief;

  Ablated(agents::Bearing whole, Parts parts) : whole_(std::move(whole)), parts_(parts) {}

  agents::Step observe(Odometry& odometry, const agents::View* view, const agents::Motion& motion) const {
    return whole_.observe(odometry, view, motion);
  }
  agents::OrRefusal<Content> extract(const Odometry& odometry, const agents::View& view) const {
    return whole_.extract(odometry, view);
  }
  Bytes encode(const Content& content) const { return whole_.encode(content); }
  Result<Content> decode(ByteView bytes) const { return whole_.decode(bytes); }
  agents::OrRefusal<agents::Related> relate(const Content& a, const Content& b,
                                            const std::optional<Relation>& guess) const {
    return whole_.relate(a, b, guess);
  }
  std::optional<agents::Signature> sign(const Content& content) const { return whole_.sign(content); }
  Chart chart(const std::vector<agents::ChartPlace<Content>>& around) const { return whole_.chart(around); }
  Belief begin(const Chart& chart, const agents::Estimate& seed) const { return whole_.begin(chart, seed); }
  Belief believed(const Chart& chart, const Belief& belief, const agents::Estimate& estimate) const {
    return whole_.believed(chart, belief, estimate);
  }

  /// Without vision: as the wheels say, and never in doubt.
  agents::Located<Belief> locate(const Chart& chart, Belief belief, const agents::Step& step,
                                 const Content& seen) const {
    if (parts_ != Parts::profile_only) return whole_.locate(chart, std::move(belief), step, seen);
    belief.centre_from_robot = std::get<AlongPath>(compose(belief.centre_from_robot, step.previous_from_current));
    const auto* nearest = &chart.stops.front();
    const auto apart = [&](const agents::Bearing::Stop& stop) {
      return std::abs(stop.centre_from_place.distance_m - belief.centre_from_robot.distance_m);
    };
    for (const agents::Bearing::Stop& stop : chart.stops) {
      if (apart(stop) < apart(*nearest)) nearest = &stop;
    }
    const Relation here = compose(inverse(Relation{nearest->centre_from_place}), belief.centre_from_robot);
    return {belief, agents::Fix{nearest->place, here, {here}}, {}};
  }

  agents::Steering steer(const agents::Ahead& ahead) const {
    const Result<agents::Spline> path = agents::Spline::through(ahead.robot_from_path);
    if (!path) return tl::unexpected(agents::Stop{"no_path"});
    constexpr double near_m = 1.0;
    constexpr double heading_gain_1_s = 3.5;
    const agents::PathPoint here = path->at(path->nearest({0.0, 0.0}, 0.0, near_m));
    const double speed_m_s = ahead.speed_limit_m_s;
    const double turn_rad_s =
        parts_ == Parts::profile_only ? speed_m_s * here.curvature_1_m : heading_gain_1_s * here.pose.heading;
    return agents::Twist{speed_m_s, turn_rad_s};
  }

 private:
  agents::Bearing whole_;
  Parts parts_;
};

}  // namespace weft::evaluate::bearing
