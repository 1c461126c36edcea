#include "clients/evaluate/ceiling/found_trial.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>
#include <variant>

#include "agents/bodies/sim/sim_body.hpp"
#include "clients/evaluate/ceiling/calibrated.hpp"
#include "clients/evaluate/ceiling/sift_map.hpp"
#include "clients/evaluate/exposed.hpp"
#include "clients/evaluate/floor/attempts/tally.hpp"
#include "clients/evaluate/floor/scenario.hpp"
#include "clients/evaluate/signed_places.hpp"

namespace weft::evaluate::ceiling {
namespace {

using namespace agents;

constexpr std::uint64_t kBesideRobot = 17;  // added to a robot's own seed
constexpr std::size_t kViews = 3;
constexpr double kWithinS = 1.05;  // a second and the stamps' jitter
constexpr std::size_t kSiftEach = 10;

/// Counts what has come of the robots that were put down.
struct Counts {
  double tried = 0.0, found = 0.0, wrong = 0.0;
  double sift_tried = 0.0, sift_found = 0.0, sift_wrong = 0.0;
  double accepted = 0.0, wrong_accepted = 0.0;

  void add_relation(const Pose2& said, const Pose2& truth) {
    accepted += 1.0;
    if (!floor::is_right(said, truth)) wrong_accepted += 1.0;
  }
};

/// Puts one body down again and again.
class PutDownRobot {
 public:
  static Result<std::unique_ptr<PutDownRobot>> make(const Way& way, const floor::Drive& drive,
                                                    const Calibrated& given) {
    sim::SimBodyConfig config = drive.body;
    config.truth_path.reset();
    auto body = sim::make_sim_body(config);
    if (!body) return fail(body.error());
    Result<Ceiling> method = Ceiling::make(given.settings, given.camera.value_or((*body)->rig().camera()));
    if (!method) return fail(method.error());
    auto robot = std::unique_ptr<PutDownRobot>(new PutDownRobot(way, drive, std::move(*body), std::move(*method)));
    if (const Result<void> learnt = robot->places_.learn(robot->method_, way.taught.map); !learnt)
      return fail(learnt.error());
    return robot;
  }

  /// Puts it down there. Returns false when it was stopped.
  Result<bool> put(const Pose2& site_from_robot, bool asks_sift, Random& random) {
    body_->put(site_from_robot, {});
    const Result<std::unique_ptr<Navigator>> navigator =
        ceiling_navigator(method_.config())(method_.camera(), std::make_shared<floor::SeenStep>());
    if (!navigator) return fail(navigator.error());
    (*navigator)->seek(std::nullopt);
    counts_.tried += 1.0;
    std::optional<SensorTime> began;
    std::size_t views = 0;
    while (views < kViews) {
      if (drive_.asked_to_stop()) return false;
      const Result<Sample> sample = body_->step({});
      if (!sample) return fail(sample.error());
      if (!began) began = sample->time;
      if (seconds(sample->time - *began) > kWithinS) break;
      const Navigated now = (*navigator)->step(*sample, way_.taught.map.view());
      expose(*body_, now);
      places_.answer(**navigator, way_.taught.map);
      note_fix(now);
      const View* const view = sample->of({});
      if (view == nullptr) continue;
      if (views++ == 0) look_closer(*view, sample->motion, asks_sift, random);
      if (const std::optional<Estimate> believed = (*navigator)->estimate()) return note_belief(*believed);
    }
    return true;
  }

  const Counts& counts() const { return counts_; }

 private:
  PutDownRobot(const Way& way, const floor::Drive& drive, std::unique_ptr<sim::SimulatedBody> body, Ceiling method)
      : way_(way),
        drive_(drive),
        body_(std::move(body)),
        method_(std::move(method)),
        sift_(way.given.settings.height_m) {
    for (const DriveWatch::Kept& kept : way.watch->kept())
      sift_.add(way.watch->camera(), kept.image, way.trace().moments.at(kept.sample).start_from_robot);
  }

  Pose2 truth_at(const PlaceId& place) const {
    return way_.taught.places.site_from_place.at(place).inverse() * body_->site_from_robot();
  }

  void note_fix(const Navigated& now) {
    if (now.fix) counts_.add_relation(planar(now.fix->evidence.a_from_b), truth_at(now.fix->place));
  }

  bool note_belief(const Estimate& believed) {
    (floor::is_right(planar(believed.place_from_robot), truth_at(believed.place)) ? counts_.found : counts_.wrong) +=
        1.0;
    return true;
  }

  /// Relates a view to places near and far, and looks for it by SIFT.
  void look_closer(const View& view, const Motion& motion, bool asks_sift, Random& random) {
    Ceiling::Odometry odometry;
    method_.observe(odometry, &view, motion);
    const std::vector<PlaceId> near = nearest_places();
    if (const auto seen = method_.extract(odometry, view); seen && !near.empty()) {
      std::vector<PlaceId> related(near.begin(), near.begin() + std::min<std::ptrdiff_t>(2, std::ssize(near)));
      related.push_back(near[near.size() / 2 + random.below(near.size() - near.size() / 2)]);
      for (const PlaceId& place : related) relate(place, *seen);
    }
    const auto* const image = std::get_if<Image>(&view.data);
    if (!asks_sift || image == nullptr || near.empty()) return;
    counts_.sift_tried += 1.0;
    const std::optional<Pose2> start_from_robot = sift_.find(method_.camera(), *image);
    if (!start_from_robot) return;
    const Pose2 said = way_.taught.places.start_from_place.at(near.front()).inverse() * *start_from_robot;
    (floor::is_right(said, truth_at(near.front())) ? counts_.sift_found : counts_.sift_wrong) += 1.0;
  }

  void relate(const PlaceId& place, const CeilingContent& seen) {
    const Place* const known = way_.taught.map.snapshot().place(place);
    const auto bytes = known == nullptr ? nullptr : way_.taught.map.find(known->content.hash);
    if (!bytes) return;
    const Result<CeilingContent> content = method_.decode(*bytes);
    if (!content) return;
    if (const auto related = method_.relate(*content, seen, std::nullopt))
      counts_.add_relation(planar(related->a_from_b), truth_at(place));
  }

  /// Returns all places, the nearest first, truly.
  std::vector<PlaceId> nearest_places() const {
    std::vector<std::pair<double, PlaceId>> by_distance;
    for (const auto& [place, pose] : way_.taught.places.site_from_place)
      by_distance.emplace_back(truth_at(place).translation().norm(), place);
    std::sort(by_distance.begin(), by_distance.end());
    std::vector<PlaceId> places;
    for (const auto& [distance_m, place] : by_distance) places.push_back(place);
    return places;
  }

  const Way& way_;
  floor::Drive drive_;
  std::unique_ptr<sim::SimulatedBody> body_;
  Ceiling method_;
  SiftMap sift_;
  SignedPlaces places_;
  Counts counts_;
};

double percent(double of, double all) {
  return all > 0.0 ? 100.0 * of / all : Score::kNothing;
}

Score score_of_found(const Counts& counts) {
  Score score;
  score.values = {{"put_downs", counts.tried},
                  {"found_percent", percent(counts.found, counts.tried)},
                  {"right_or_refused_percent", percent(counts.tried - counts.wrong, counts.tried)},
                  {"wrong", counts.wrong},
                  {"sift_put_downs", counts.sift_tried},
                  {"sift_percent", percent(counts.sift_found, counts.sift_tried)},
                  {"sift_wrong", counts.sift_wrong},
                  {"sift_wrong_percent", percent(counts.sift_wrong, counts.sift_tried)},
                  {"accepted", counts.accepted},
                  {"wrong_accepted", counts.wrong_accepted}};
  return score;
}

}  // namespace

Pose2 anywhere_on(const std::vector<SitePoint>& line, Random& random) {
  constexpr double most_beside_m = 0.5;
  constexpr double piece_m = 0.1;
  const double from_m = random.uniform(0.0, floor::length_of(line) - piece_m);
  const Pose2 on_line = beginning_of(floor::stretch(line, from_m, from_m + piece_m));
  const double beside_m = random.uniform(-most_beside_m, most_beside_m);
  return on_line * Pose2{0.0, beside_m, random.uniform(-std::numbers::pi, std::numbers::pi)};
}

Result<std::optional<Measured>> measure_found(const Way& way, const Driven& driven, const PutDowns& put_downs,
                                              const Scenes& scenes) {
  sim::Site site = way.scene.site;
  site.change.lamps_failed = put_downs.lamps_failed;
  Driven other = driven;
  other.day = 1;
  for (sim::RobotStart& start : site.robots) {
    if (start.name != driven.robot) continue;
    start.name = other.robot = "beside";
    start.seed += kBesideRobot;
    break;
  }
  const auto given = calibrated(scenes, site, other);
  if (!given) return fail(given.error());
  if (!*given) return std::optional<Measured>();
  auto robot = PutDownRobot::make(way, drive_of(site, other, **given), **given);
  if (!robot) return fail(robot.error());
  for (std::size_t i = 0; i < put_downs.count; ++i) {
    Random random = Random(driven.seed).fork(100 + i);
    const Pose2 site_from_robot = anywhere_on(way.scene.line, random);
    const Result<bool> put = (*robot)->put(site_from_robot, i % kSiftEach == 0, random);
    if (!put) return fail(put.error());
    if (!*put) return std::optional<Measured>();
  }
  return std::optional(Measured{score_of_found((*robot)->counts()), {}});
}

}  // namespace weft::evaluate::ceiling
