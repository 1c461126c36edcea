#pragma once
#include <algorithm>
#include <utility>
#include <vector>

#include "agents/control/spline.hpp"
#include "agents/methods/bearing/bearing.hpp"
#include "clients/evaluate/bearing/course.hpp"

namespace weft::evaluate::bearing {

/// Drives by `bearing` with parts taken away, steered as Krajnik et al. 2018 do: turning as taught, and against the
/// heading seen. The distance stays the wheels'; or (IV-B) the profile is replayed without looking, or the robot
/// drives at a constant speed, steers by what it sees alone, and knows no bends.
class Ablated {
 public:
  static constexpr std::string_view name = agents::Bearing::name;
  static constexpr std::uint32_t content_format = agents::Bearing::content_format;
  static constexpr agents::ChartSize chart_size = agents::Bearing::chart_size;
  static constexpr bool steers_along_a_path = true;
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
  std::optional<agents::Exposure> expose(const Odometry& odometry, const agents::View& view) const {
    return whole_.expose(odometry, view);
  }
  Bytes encode(const Content& content) const { return whole_.encode(content); }
  Result<Content> decode(ByteView bytes) const { return whole_.decode(bytes); }
  agents::OrRefusal<agents::Related> relate(const Content& a, const Content& b,
                                            const std::optional<Relation>& guess) const {
    return whole_.relate(a, b, guess);
  }
  static agents::Twist driven(const Content& content) { return agents::Bearing::driven(content); }
  std::optional<agents::Signature> sign(const Content& content) const { return whole_.sign(content); }
  Chart chart(const std::vector<agents::ChartPlace<Content>>& around) const { return whole_.chart(around); }
  Belief begin(const Chart& chart, const agents::Estimate& seed) const { return whole_.begin(chart, seed); }
  Belief begin(const Chart& chart, const agents::Estimate& seed, const Belief& before) const {
    return whole_.begin(chart, seed, before);
  }
  Belief believed(const Chart& chart, const Belief& belief, const agents::Estimate& estimate) const {
    return whole_.believed(chart, belief, estimate);
  }

  agents::Located<Belief> locate(const Chart& chart, Belief belief, const agents::Step& step,
                                 const Content& seen) const {
    if (parts_ == Parts::profile_only) return as_the_wheels_say(chart, std::move(belief), step);
    if (parts_ == Parts::vision_only) return turned_as_it_looks(chart, std::move(belief), step, seen);
    agents::Located<Belief> located = whole_.locate(chart, std::move(belief), step, seen);
    if (located.fix) forget_how_far(chart, located);
    return located;
  }

  agents::Steering steer(Odometry&, const agents::Around<Ablated>*, const agents::Ahead& ahead) const {
    const Result<agents::Spline> path = agents::Spline::through(ahead.robot_from_path);
    if (!path) return tl::unexpected(agents::Stop{"no_path"});
    if (parts_ == Parts::vision_only) return towards_what_is_seen(ahead);
    constexpr double near_m = 1.0;
    constexpr double heading_gain_1_s = 3.5;
    const agents::PathPoint here = path->at(path->nearest({0.0, 0.0}, 0.0, near_m));
    constexpr double brakes_1_s = 1.0;
    constexpr double creeps_m_s = 0.03;
    constexpr double there_m = 0.004;
    double speed_m_s = ahead.speed_limit_m_s;
    if (ahead.end_is_goal) speed_m_s = std::min(speed_m_s, std::max(creeps_m_s, brakes_1_s * ahead.to_end_m));
    if (ahead.to_end_m <= there_m) speed_m_s = 0.0;
    const double taught_rad_s = speed_m_s * here.curvature_1_m;
    const double seen_rad_s = parts_ == Parts::profile_only ? 0.0 : heading_gain_1_s * here.pose.heading;
    return agents::Twist{speed_m_s, taught_rad_s + seen_rad_s};
  }

 private:
  static const agents::Bearing::Stop& stop_of(const Chart& chart, const PlaceId& place) {
    return *std::find_if(chart.stops.begin(), chart.stops.end(),
                         [&](const agents::Bearing::Stop& stop) { return stop.place == place; });
  }

  /// Returns where the wheels alone take the robot to be; never in doubt.
  static agents::Located<Belief> as_the_wheels_say(const Chart& chart, Belief belief, const agents::Step& step) {
    belief.centre_from_robot = std::get<AlongPath>(compose(belief.centre_from_robot, step.previous_from_current));
    const auto apart = [&](const agents::Bearing::Stop& stop) {
      return std::abs(stop.centre_from_place.distance_m - belief.centre_from_robot.distance_m);
    };
    const auto nearest = std::min_element(chart.stops.begin(), chart.stops.end(),
                                          [&](const auto& a, const auto& b) { return apart(a) < apart(b); });
    const Relation here = compose(inverse(Relation{nearest->centre_from_place}), belief.centre_from_robot);
    return {belief, agents::Fix{nearest->place, here, {here}}, {}};
  }

  /// Returns the heading that the place at this distance shows, none where it shows none; wheels tell of no turn.
  agents::Located<Belief> turned_as_it_looks(const Chart& chart, Belief belief, const agents::Step& step,
                                             const Content& seen) const {
    agents::Located<Belief> located = as_the_wheels_say(chart, std::move(belief), step);
    const agents::Bearing::Stop& stop = stop_of(chart, located.fix->place);
    AlongPath here = std::get<AlongPath>(located.fix->place_from_robot);
    here.heading_shift_rad = 0.0;
    if (stop.content != nullptr) {
      const auto shown = whole_.relate(*stop.content, seen, Relation{here});
      if (shown) here.heading_shift_rad = std::get<AlongPath>(shown->a_from_b).heading_shift_rad;
    }
    located.belief.centre_from_robot = std::get<AlongPath>(compose(Relation{stop.centre_from_place}, here));
    located.fix->place_from_robot = here;
    located.fix->evidence.a_from_b = here;
    return located;
  }

  /// Steers at a constant speed, and as gently as a robot may that looks ten times a second.
  static agents::Twist towards_what_is_seen(const agents::Ahead& ahead) {
    constexpr double speed_m_s = 0.5;  // at which the straights are taught
    constexpr double heading_gain_1_s = 1.0;
    const auto place = std::min_element(
        ahead.robot_from_path.begin(), ahead.robot_from_path.end(),
        [](const Pose2& a, const Pose2& b) { return a.translation().norm() < b.translation().norm(); });
    return {speed_m_s, heading_gain_1_s * place->heading};
  }

  /// Takes the seen distance out of a fix: only its heading counts, the distance stays the wheels'.
  static void forget_how_far(const Chart& chart, agents::Located<Belief>& located) {
    const AlongPath& centre_from_place = stop_of(chart, located.fix->place).centre_from_place;
    const Relation by_wheels = compose(inverse(Relation{centre_from_place}), located.belief.centre_from_robot);
    auto& told = std::get<AlongPath>(located.fix->place_from_robot);
    constexpr double tells_nothing_m2 = 1e4;
    told.distance_m = std::get<AlongPath>(by_wheels).distance_m;
    told.distance_variance_m2 = tells_nothing_m2;
    located.fix->evidence.a_from_b = told;
  }

  agents::Bearing whole_;
  Parts parts_;
};
static_assert(agents::Remembers<Ablated> && agents::SteersItself<Ablated> && agents::Exposes<Ablated>);

}  // namespace weft::evaluate::bearing
