#include "clients/evaluate/ceiling/loop_trial.hpp"

#include <cmath>

#include "clients/evaluate/ceiling/frames/compared.hpp"
#include "clients/evaluate/floor/attempts/tally.hpp"

namespace weft::evaluate::ceiling {
namespace {

/// Holds the places of a way in the order in which they were kept.
struct PlacesOfWay {
  std::vector<Pose2> truth;
  std::vector<Pose2> by_odometry;
  std::vector<Pose2> by_mosaic;
};

PlacesOfWay places_of_way(const Way& way) {
  PlacesOfWay places;
  const std::vector<floor::Moment>& moments = way.trace().moments;
  for (std::size_t i = 0; i < moments.size(); ++i) {
    if (!moments[i].kept) continue;
    places.truth.push_back(moments[i].site_from_robot);
    places.by_odometry.push_back(moments[i].start_from_robot);
    places.by_mosaic.push_back(way.watch->mosaic().at(i));
  }
  return places;
}

/// Returns how far a position at the way's end is off, of what was driven; percent.
double drift_percent(const Way& way, const Pose2& start_from_end) {
  const std::vector<floor::Moment>& moments = way.trace().moments;
  const Pose2 truly = moments.front().site_from_robot.inverse() * moments.back().site_from_robot;
  const Pose2 first = moments.front().start_from_robot;
  const Pose2 moved = first.inverse() * start_from_end;
  return 100.0 * (moved.translation() - truly.translation()).norm() / floor::metres_driven(way.trace()).back();
}

/// Counts the stitches of the map and those that are wrong.
void add_stitches(const Way& way, Score& score) {
  double stitches = 0.0;
  double wrong = 0.0;
  const auto& truth = way.taught.places.site_from_place;
  for (const auto& [id, experience] : way.taught.map.snapshot().experiences()) {
    for (const Edge& edge : experience->stitches) {
      stitches += 1.0;
      const Pose2 a_from_b = truth.at(edge.id.a).inverse() * truth.at(edge.id.b);
      if (!floor::is_right(planar(edge.a_from_b), a_from_b)) wrong += 1.0;
    }
  }
  score.values["stitches"] = stitches;
  score.values["wrong_stitches"] = wrong;
}

void show(const std::vector<Pose2>& truth, const std::vector<Pose2>& laid, const char* name, Shown& shown) {
  const Pose2 truth_from_laid = aligned(truth, laid).a_from_b;
  for (const Pose2& pose : laid) {
    const Eigen::Vector2d at = truth_from_laid * pose.translation();
    shown[name].push_back({at.x(), at.y()});
  }
}

}  // namespace

std::vector<Pose2> chained(const Experience& experience) {
  std::vector<Pose2> poses;
  Pose2 first_from_place;
  for (const Place& place : experience.places) {
    poses.push_back(first_from_place);
    if (const Edge* const hop = experience.hop(place.id.index))
      first_from_place = first_from_place * planar(hop->a_from_b);
  }
  return poses;
}

Measured measure_loop(const Way& way) {
  Measured measured;
  Score& score = measured.score;
  const PlacesOfWay places = places_of_way(way);
  const auto rms_mm = [&](const std::vector<Pose2>& laid) { return 1e3 * aligned(places.truth, laid).rms_m; };
  score.values["places"] = static_cast<double>(places.truth.size());
  score.values["refined"] = way.taught.refined ? 1.0 : 0.0;
  score.values["chain_rms_mm"] = rms_mm(places.by_odometry);
  score.values["composed_rms_mm"] = rms_mm(places.by_mosaic);
  score.values["drift_percent"] = drift_percent(way, way.trace().moments.back().start_from_robot);
  score.values["composed_drift_percent"] = drift_percent(way, way.watch->mosaic().back());
  const Experience* const experience = way.taught.map.snapshot().experience(way.taught.last.experience);
  if (way.taught.refined && experience != nullptr) {
    const std::vector<Pose2> refined = chained(*experience);
    score.values["adjusted_rms_mm"] = rms_mm(refined);
    score.values["adjusted_percent"] = 100.0 * rms_mm(refined) / rms_mm(places.by_odometry);
    show(places.truth, refined, "adjusted", measured.shown);
  }
  add_stitches(way, score);
  add_held({&way.trace()}, score);
  for (const Pose2& pose : places.truth) measured.shown["truth"].push_back({pose.x, pose.y});
  show(places.truth, places.by_odometry, "odometry", measured.shown);
  show(places.truth, places.by_mosaic, "composed", measured.shown);
  return measured;
}

}  // namespace weft::evaluate::ceiling
