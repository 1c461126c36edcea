// Where along the path, and turned by how much: the default search relates one place; here the places before and
// behind are held against each other.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <map>

#include "agents/methods/bearing/bearing.hpp"
#include "agents/perception/looming.hpp"

namespace weft::agents {
namespace {

const AlongPath& along(const Relation& relation) {
  return std::get<AlongPath>(relation);
}

AlongPath as_along(const Relation& relation) {
  return along(compose(relation, AlongPath{}));
}

/// Describes a place that told a heading.
struct Told {
  const Bearing::Stop* stop;
  HeadingVote vote;
  std::optional<Looming> looming;  ///< of the robot's view against the place's
  double robot_m = 0.0;            ///< the place's distance from the robot, as believed; ahead positive
  double focal_variance = 0.0;     ///< of the share that is taken off `looming`
};

/// Describes by how much the robot is further along the path than believed.
struct Further {
  double ahead_m = 0.0;
  double variance_m2 = 0.0;
  double looming_1_m = 0.0;  ///< share by which things are nearer for each metre
};

/// Estimates how much further along the path the robot is than believed. Places ahead show things smaller than the
/// robot sees them, places behind larger, the more so the further off they are: where that changes sign is the robot.
/// Fits a line to both by least squares; its slope tells how far away things are, which is known roughly beforehand.
/// None: hardly anything is told.
std::optional<Further> further_of(const std::vector<Told>& told) {
  constexpr double usual_1_m = 0.35;  // of things 1 to 10 m away
  constexpr double usual_sigma_1_m = 0.3;
  constexpr double bent = 0.25;  // share by which what is told of a place far off is no line any more
  constexpr double least_1_m = 0.03;
  std::optional<Further> further;
  for (int round = 0; round < 2; ++round) {
    constexpr double knows = 1.0 / (usual_sigma_1_m * usual_sigma_1_m);
    Eigen::Matrix2d normal = Eigen::Vector2d(knows, 0.0).asDiagonal();
    Eigen::Vector2d right(knows * usual_1_m, 0.0);
    bool has_any = false;
    for (const Told& one : told) {
      if (!one.looming) continue;
      const double off_m = one.robot_m - (further ? further->ahead_m : 0.0);
      const double blurred = bent * usual_1_m * off_m;
      const double weight = 1.0 / (one.looming->variance + blurred * blurred);
      const Eigen::Vector2d row(-one.robot_m, 1.0);
      normal += weight * row * row.transpose();
      right += weight * one.looming->share * row;
      has_any = true;
    }
    if (!has_any) return std::nullopt;
    const Eigen::Matrix2d covariance = normal.inverse();
    const Eigen::Vector2d line = covariance * right;
    if (!(line.x() > least_1_m)) return std::nullopt;
    const double ahead_m = line.y() / line.x();
    const Eigen::Vector2d by_line(-ahead_m / line.x(), 1.0 / line.x());
    further = Further{ahead_m, by_line.dot(covariance * by_line), line.x()};
  }
  return further;
}

/// Returns those that agree on how the robot is turned if they are most of them, else none: each alone finds a
/// heading by chance now and then. In a bend places look in other directions, and each mistakes for a turn what of
/// the robot's distance from the path lies across its own direction: so more is allowed there.
std::vector<Told> agreeing(const std::vector<Told>& told) {
  constexpr double near_rad = 0.06;
  constexpr double aside = 0.35;  // distance from the way over that of things: 1 m of 3 m
  constexpr std::size_t too_few_to_say = 2;
  if (told.size() <= too_few_to_say) return told;
  const auto place_rad = [](const Told& one) { return one.stop->centre_from_place.heading_shift_rad; };
  const auto robot_rad = [&](const Told& one) {
    return place_rad(one) + std::atan(one.vote.shift_px / one.stop->content->focal_px);
  };
  std::vector<Told> ordered = told;
  const auto at = ordered.begin() + static_cast<std::ptrdiff_t>(ordered.size() / 2);
  std::nth_element(ordered.begin(), at, ordered.end(),
                   [&](const Told& a, const Told& b) { return robot_rad(a) < robot_rad(b); });
  const Told middle = *at;
  std::vector<Told> agree = told;
  std::erase_if(agree, [&](const Told& one) {
    return std::abs(wrap_angle(robot_rad(one) - robot_rad(middle))) >
           near_rad + aside * std::abs(wrap_angle(place_rad(one) - place_rad(middle)));
  });
  if (2 * agree.size() <= told.size()) agree.clear();
  return agree;
}

/// Estimates how the robot's focal length compares with that of the camera that taught most of these, by their
/// features as they are. From before or behind them all nothing is told: a step and a longer lens look too much
/// alike.
std::optional<CameraLook> look_at_camera(const OtherCameras& cameras, const std::vector<Told>& told,
                                         const Further& further, const BearingContent& seen) {
  constexpr std::ptrdiff_t fewest = 2;  // on either side
  constexpr double near_m = 0.1;        // to where it is believed: the views that are compared lie about it
  const auto run_of = [](const Told& one) { return one.stop->place.experience; };
  const auto places_of = [&](const ExperienceId& run) {
    return std::count_if(told.begin(), told.end(), [&](const Told& one) { return run_of(one) == run; });
  };
  const ExperienceId run = run_of(*std::max_element(told.begin(), told.end(), [&](const Told& a, const Told& b) {
    return places_of(run_of(a)) < places_of(run_of(b));
  }));
  if (!cameras.is_due(run) || std::abs(further.ahead_m) > near_m) return std::nullopt;
  std::vector<OtherView> views;
  for (const Told& one : told)
    if (run_of(one) == run && one.stop->content->focal_px == seen.focal_px)
      views.push_back({one.robot_m - further.ahead_m, &one.stop->content->features, &one.vote.agreeing});
  const auto ahead =
      std::count_if(views.begin(), views.end(), [](const OtherView& view) { return view.ahead_m > 0.0; });
  if (ahead < fewest || std::ssize(views) - ahead < fewest) return std::nullopt;
  const std::optional<FocalShare> share = focal_share_of(views, seen.features, seen.focal_px);
  return share ? std::optional(CameraLook{run, *share}) : std::nullopt;
}

/// Takes off each looming what unlike focal lengths cause: things seem as much nearer as a focal length is larger.
void take_off_focal_shares(std::vector<Told>& told, const OtherCameras& cameras, double sigma) {
  for (Told& one : told) {
    const FocalShare focal = cameras.of(one.stop->place.experience, sigma);
    if (one.looming) one.looming->share -= focal.share;
    one.focal_variance = focal.variance;
  }
}

}  // namespace

static_assert(Remembers<Bearing>);

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

Bearing::Belief Bearing::begin(const Chart& chart, const Estimate& seed, const Belief& before) const {
  Belief now = begin(chart, seed);
  now.cameras = before.cameras;
  return now;
}

Bearing::Belief Bearing::believed(const Chart& chart, const Belief& before, const Estimate& estimate) const {
  Belief now = begin(chart, estimate, before);
  if (before.look) now.cameras.told(*before.look, config_.focal_share);
  if (before.rise) now.cameras.told(*before.rise);
  return now;
}

Located<Bearing::Belief> Bearing::locate(const Chart& chart, Belief belief, const Step& step,
                                         const Content& seen) const {
  belief.centre_from_robot = as_along(compose(belief.centre_from_robot, step.previous_from_current));
  belief.cameras.moved(distance_m(step.previous_from_current));
  belief.look.reset();
  belief.rise.reset();
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
  std::map<ExperienceId, double> rises;
  for (const Stop* const stop : near) {
    if (stop->content->description != seen.description) {
      located.refusals.push_back({"described_otherwise"});
      continue;
    }
    const ExperienceId& run = stop->place.experience;
    if (!rises.contains(run)) {
      const std::optional<double> known_px = belief.cameras.rise_px(run);
      rises[run] = known_px ? *known_px
                            : frequent_rise(stop->content->features, seen.features, config_.width_px, config_.vote);
      if (!known_px && !located.belief.rise) located.belief.rise = CameraRise{run, rises[run]};
    }
    const auto vote =
        vote_heading(stop->content->features, seen.features, config_.width_px, config_.vote, rises[run]);
    if (vote) {
      told.push_back({stop, *vote,
                      looming_of(stop->content->features, seen.features, vote->agreeing, stop->content->focal_px),
                      stop->centre_from_place.distance_m - here_m});
    } else {
      located.refusals.push_back({vote.error().reason, vote.error().measured, vote.error().bound});
    }
  }
  if (near.empty()) located.refusals.push_back({"nothing_near", 0.0, config_.neighbours_m});
  if (told.empty()) return located;
  const std::size_t all = told.size();
  told = agreeing(told);
  if (told.empty()) {
    located.refusals.push_back({"headings_differ", static_cast<double>(all), 0.0});
    return located;
  }

  take_off_focal_shares(told, belief.cameras, config_.focal_share);
  const std::optional<Further> further = further_of(told);
  if (further) located.belief.look = look_at_camera(belief.cameras, told, *further, seen);
  const double ahead_m = further ? further->ahead_m : 0.0;
  const auto nearest = std::min_element(told.begin(), told.end(), [&](const Told& a, const Told& b) {
    return std::abs(a.robot_m - ahead_m) < std::abs(b.robot_m - ahead_m);
  });
  AlongPath place_from_robot =
      as_along(compose(inverse(Relation{nearest->stop->centre_from_place}), belief.centre_from_robot));
  if (further) {
    place_from_robot.distance_m = ahead_m - nearest->robot_m;
    place_from_robot.distance_variance_m2 = config_.along_sigma_m * config_.along_sigma_m + further->variance_m2 +
                                            nearest->focal_variance / (further->looming_1_m * further->looming_1_m);
  }
  if (nearest->looming) {
    place_from_robot.heading_shift_rad = nearest->looming->turned_rad;
    place_from_robot.heading_variance_rad2 =
        config_.vote_sigma_rad * config_.vote_sigma_rad + nearest->looming->turned_variance_rad2;
  } else {
    place_from_robot.heading_shift_rad = std::atan(nearest->vote.shift_px / nearest->stop->content->focal_px);
    place_from_robot.heading_variance_rad2 =
        config_.vote_sigma_rad * config_.vote_sigma_rad * (1.0 + 20.0 / nearest->vote.votes);
  }
  const Related evidence{place_from_robot, nearest->vote.votes,
                         static_cast<double>(nearest->vote.votes) / std::max(1U, nearest->vote.matches),
                         nearest->vote.runner_up};
  located.fix = Fix{nearest->stop->place, place_from_robot, evidence};
  return located;
}

}  // namespace weft::agents
