#include "clients/evaluate/floor/attempts/navigating.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "agents/navigation/localiser.hpp"
#include "agents/navigation/own_map.hpp"
#include "agents/navigation/stitcher.hpp"
#include "agents/navigation/teacher.hpp"

namespace weft::evaluate::floor {
namespace {

using namespace agents;

/// Draws what a robot believes and how far that is off: within what it says, or by several tenths of a metre.
Relation believed(const Pose2& truth, bool knows, double most_sigma_m, Random& random) {
  const double sigma_m = knows ? random.uniform(0.005, most_sigma_m) : random.uniform(0.005, 0.03);
  const double sigma_rad = knows ? 0.02 : 0.01;
  Pose2 off{sigma_m * random.normal(), sigma_m * random.normal(), sigma_rad * random.normal()};
  if (!knows) {
    const double towards = random.uniform(-std::numbers::pi, std::numbers::pi);
    const double away_m = random.uniform(0.25, 0.8);
    off = {away_m * std::cos(towards), away_m * std::sin(towards), off.heading};
  }
  return Metric2{truth * off,
                 Eigen::Vector3d(sigma_m * sigma_m, sigma_m * sigma_m, sigma_rad * sigma_rad).asDiagonal()};
}

/// Returns the place that the robot stands nearest to. None: none within reach.
std::optional<std::size_t> nearest(const KnownPlaces& places, const Pose2& site_from_robot) {
  constexpr double kReachM = 1.0;
  std::optional<std::size_t> best;
  double best_m = kReachM;
  for (std::size_t i = 0; i < places.all().size(); ++i) {
    const Pose2 apart = places.all()[i].shows.site_from_robot.inverse() * site_from_robot;
    if (apart.translation().norm() >= best_m) continue;
    best = i;
    best_m = apart.translation().norm();
  }
  return best;
}

/// Returns the worse of two readings of a fix: as it was measured, and as it is believed.
Pose2 worse_of(const Fix& fix, const Pose2& truth) {
  const Pose2 measured = planar(fix.evidence.a_from_b);
  return is_right(measured, truth) ? planar(fix.place_from_robot) : measured;
}

}  // namespace

Navigating::Navigating(const Floor& method, const Taught& taught, const KnownPlaces& places)
    : method_(method),
      taught_(taught),
      places_(places),
      decoded_(method_, std::uint64_t{config_.locate.decoded_mb} << 20U) {}

void Navigating::navigate(const Passage& passage, bool is_other_floor, Random& random, Tally& tally) {
  seek(passage, is_other_floor, tally);
  if (is_other_floor) return;
  for (const bool knows : {true, false}) {
    track(passage, knows, random, tally);
    stitch(passage, knows, random, tally);
  }
}

void Navigating::seek(const Passage& passage, bool is_other_floor, Tally& tally) {
  const char* const sort = is_other_floor ? attempted::kSeekingOther : attempted::kSeeking;
  Localiser<Floor> localiser(method_, config_);
  localiser.seek(std::nullopt);
  const MapView map = taught_.map.view();
  for (const Look& look : passage.looks) {
    localiser.advance(look.step);
    if (!look.content) continue;
    const auto outcome = localiser.attempt(*look.content, map.window, map.contents, decoded_, {});
    if (!outcome.fix) {
      if (!outcome.refusals.empty()) tally.count(sort, tl::unexpected(outcome.refusals.back()), std::nullopt, {});
      continue;
    }
    const Pose2 site_from_place = taught_.places.site_from_place.at(outcome.fix->place);
    const Pose2 truth = site_from_place.inverse() * look.site_from_robot;
    tally.count(sort, worse_of(*outcome.fix, truth), is_other_floor ? std::nullopt : std::optional(truth),
                site_from_place);
    return;
  }
}

void Navigating::track(const Passage& passage, bool knows, Random& random, Tally& tally) {
  constexpr double kMostSigmaM = 0.05;
  const char* const sort = knows ? attempted::kTracking : attempted::kTrackingLost;
  const Pose2 start = passage.looks.front().site_from_robot;
  const std::optional<std::size_t> at = nearest(places_, start);
  if (!at) return;
  const KnownPlaces::Known& place = places_.all()[*at];
  Localiser<Floor> localiser(method_, config_);
  localiser.set({place.id, believed(place.shows.site_from_robot.inverse() * start, knows, kMostSigmaM, random), {}});
  const MapView map = taught_.map.view();
  for (const Look& look : passage.looks) {
    if (&look != &passage.looks.front()) localiser.advance(look.step);
    if (!look.content) continue;
    const auto outcome = localiser.attempt(*look.content, map.window, map.contents, decoded_, {});
    if (!outcome.fix) {
      if (!outcome.refusals.empty()) tally.count(sort, tl::unexpected(outcome.refusals.back()), std::nullopt, {});
      continue;
    }
    const Pose2 site_from_place = taught_.places.site_from_place.at(outcome.fix->place);
    const Pose2 truth = site_from_place.inverse() * look.site_from_robot;
    tally.count(sort, worse_of(*outcome.fix, truth), truth, site_from_place);
  }
}

void Navigating::stitch(const Passage& passage, bool knows, Random& random, Tally& tally) {
  constexpr double kMostSigmaM = 0.30;
  const char* const sort = knows ? attempted::kStitching : attempted::kStitchingLost;
  const Pose2 start = passage.looks.front().site_from_robot;
  const std::optional<std::size_t> at = nearest(places_, start);
  const Look& last = passage.looks.back();
  if (!at || !passage.looks.front().content || !last.content) return;
  const KnownPlaces::Known& place = places_.all()[*at];
  const MapView map = taught_.map.view();
  Stitcher<Floor> stitcher(method_, config_);
  Teacher teacher(config_.teach, {ExperienceId{std::numeric_limits<std::uint32_t>::max()}, RobotId{}}, Floor::name,
                  Floor::content_format);
  OwnMap own(Floor::name);
  for (const Look& look : passage.looks) {
    if (&look != &passage.looks.front()) teacher.advance(look.step);
    if (&look != &passage.looks.front() && &look != &last) continue;
    const Kept kept = teacher.keep(method_.encode(*look.content), 0, {});
    own.add(kept.place, kept.edges);
    own.update(map.window, map.generation, false);
    if (&look != &last) {
      Edge anchor;
      anchor.id = {place.id, kept.place.id};
      anchor.a_from_b = believed(place.shows.site_from_robot.inverse() * start, knows, kMostSigmaM, random);
      anchor.origin = Origin::stitch;
      anchor.drivable = Drivable::none;
      own.anchor(anchor);
    }
    const auto found = stitcher.look(own.map(map.window), map.contents, decoded_, teacher, kept.place, *look.content);
    for (const Edge& edge : found.edges) {
      const Pose2 site_from_place = taught_.places.site_from_place.at(edge.id.a);
      tally.count(sort, planar(edge.a_from_b), site_from_place.inverse() * look.site_from_robot, site_from_place);
    }
    for (const Refusal& refusal : found.refusals) tally.count(sort, tl::unexpected(refusal), std::nullopt, {});
  }
}

}  // namespace weft::evaluate::floor
