// Where along the path, and turned by how much: the default search relates one place; here the places before and
// behind are held against each other.
#include <algorithm>
#include <cmath>

#include "agents/methods/bearing/bearing.hpp"

namespace weft::agents {
namespace {

const AlongPath& along(const Relation& relation) {
  return std::get<AlongPath>(relation);
}

AlongPath as_along(const Relation& relation) {
  return along(compose(relation, AlongPath{}));
}

/// A place that told a heading.
struct Told {
  const Bearing::Stop* stop;
  HeadingVote vote;
  double robot_m = 0.0;  ///< the place's distance from the robot, as believed; ahead positive
};

/// Weighed by what stands out of chance: how far ahead of the robot, as believed, the place that looks most alike
/// lies.
struct Peak {
  double ahead_m = 0.0;
  bool is_told = false;
};

/// The vertex of the parabola through what stands out of chance, by least squares; told where it is a peak between
/// the places compared.
Peak peak_of(const std::vector<Told>& told) {
  if (told.size() < 4) return {};
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double least = told.front().robot_m;
  double most = least;
  for (const Told& one : told) {
    const Eigen::Vector3d row(1.0, one.robot_m, one.robot_m * one.robot_m);
    normal += row * row.transpose();
    right += row * one.vote.above_chance;
    least = std::min(least, one.robot_m);
    most = std::max(most, one.robot_m);
  }
  const Eigen::Vector3d fit = normal.ldlt().solve(right);
  if (!(fit.z() < 0.0)) return {};
  const double vertex = -0.5 * fit.y() / fit.z();
  return {vertex, vertex > least && vertex < most};
}

}  // namespace

Bearing::Chart Bearing::chart(const std::vector<ChartPlace<Content>>& around) const {
  Chart chart;
  for (const ChartPlace<Content>& place : around)
    chart.stops.push_back({place.id, as_along(place.centre_from_place), place.content});
  std::stable_sort(chart.stops.begin(), chart.stops.end(), [](const Stop& a, const Stop& b) {
    return a.centre_from_place.distance_m < b.centre_from_place.distance_m;
  });
  return chart;
}

Bearing::Belief Bearing::begin(const Chart& chart, const Estimate& seed) const {
  for (const Stop& stop : chart.stops) {
    if (stop.place == seed.place) return {as_along(compose(stop.centre_from_place, seed.place_from_robot))};
  }
  return {as_along(seed.place_from_robot)};
}

Located<Bearing::Belief> Bearing::locate(const Chart& chart, Belief belief, const Step& step,
                                         const Content& seen) const {
  belief.centre_from_robot = as_along(compose(belief.centre_from_robot, step.previous_from_current));
  Located<Belief> located{belief, std::nullopt, {}};
  const double here_m = belief.centre_from_robot.distance_m;
  std::vector<const Stop*> near;
  for (const Stop& stop : chart.stops) {
    if (stop.content != nullptr && std::abs(stop.centre_from_place.distance_m - here_m) <= config_.neighbours_m)
      near.push_back(&stop);
  }
  std::stable_sort(near.begin(), near.end(), [&](const Stop* a, const Stop* b) {
    return std::abs(a->centre_from_place.distance_m - here_m) < std::abs(b->centre_from_place.distance_m - here_m);
  });
  if (near.size() > static_cast<std::size_t>(config_.most_neighbours))
    near.resize(static_cast<std::size_t>(config_.most_neighbours));
  std::vector<Told> told;
  for (const Stop* const stop : near) {
    const auto vote = vote_heading(stop->content->features, seen.features, config_.width_px, config_.vote);
    if (vote) {
      told.push_back({stop, *vote, stop->centre_from_place.distance_m - here_m});
    } else {
      located.refusals.push_back({vote.error().reason, vote.error().measured, vote.error().bound});
    }
  }
  if (near.empty()) located.refusals.push_back({"nothing_near", 0.0, config_.neighbours_m});
  if (told.empty()) return located;

  const Peak peak = peak_of(told);
  const double ahead_m = peak.is_told ? peak.ahead_m : 0.0;
  const auto nearest = std::min_element(told.begin(), told.end(), [&](const Told& a, const Told& b) {
    return std::abs(a.robot_m - ahead_m) < std::abs(b.robot_m - ahead_m);
  });
  AlongPath place_from_robot =
      as_along(compose(inverse(Relation{nearest->stop->centre_from_place}), belief.centre_from_robot));
  if (peak.is_told) {
    place_from_robot.distance_m = ahead_m - nearest->robot_m;
    place_from_robot.distance_variance_m2 = config_.along_sigma_m * config_.along_sigma_m;
  }
  place_from_robot.heading_shift_rad = std::atan(nearest->vote.shift_px / nearest->stop->content->focal_px);
  place_from_robot.heading_variance_rad2 =
      config_.vote_sigma_rad * config_.vote_sigma_rad * (1.0 + 20.0 / nearest->vote.votes);
  const Related evidence{place_from_robot, nearest->vote.votes,
                         static_cast<double>(nearest->vote.votes) / std::max(1U, nearest->vote.matches),
                         nearest->vote.runner_up};
  located.fix = Fix{nearest->stop->place, place_from_robot, evidence};
  located.belief.centre_from_robot = as_along(compose(nearest->stop->centre_from_place, place_from_robot));
  return located;
}

}  // namespace weft::agents
