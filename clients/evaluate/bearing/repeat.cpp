#include <algorithm>
#include <utility>

#include "agents/navigation/navigator_of.hpp"
#include "clients/evaluate/bearing/ablated.hpp"
#include "clients/evaluate/bearing/course.hpp"

namespace weft::evaluate::bearing {

using namespace agents;

namespace {

constexpr int kLookAtMost = 60;       // samples standing, until it is given up as not localised
constexpr int kStandsAtMost = 120;    // samples on its way without moving on
constexpr double kLongestS = 4000.0;  // on the simulation's clock

/// Drives one robot along its way, and keeps what it has driven.
class Repeating {
 public:
  Repeating(const Course& course, std::unique_ptr<sim::SimulatedBody> body, std::unique_ptr<Navigator> navigator)
      : course_(course), body_(std::move(body)), navigator_(std::move(navigator)) {}

  Navigator& navigator() { return *navigator_; }
  double driven_m() const { return driven_m_; }
  double now_s() const { return now_s_; }

  Result<Navigated> step() {
    const Pose2 before = body_->site_from_robot();
    const Result<Sample> sample = body_->step(command_);
    if (!sample) return fail(sample.error());
    Navigated now = navigator_->step(*sample, course_.map.view());
    command_ = now.command;
    expose(*body_, now);
    now_s_ = seconds(sample->time.time_since_epoch());
    driven_m_ += (before.inverse() * body_->site_from_robot()).translation().norm();
    return now;
  }

  /// Returns how far the robot is from where it believes to be. None: it does not know where it is.
  std::optional<Deviation> deviation() const {
    const std::optional<Estimate> here = navigator_->estimate();
    if (!here) return std::nullopt;
    const double beyond_m = planar(here->place_from_robot).x;
    const Pose2 site_from_path = course_.site_from_path(here->place.index, beyond_m);
    return Deviation{driven_m_, course_.along_m[here->place.index] + beyond_m, body_->site_from_robot(),
                     site_from_path.inverse() * body_->site_from_robot()};
  }

 private:
  const Course& course_;
  std::unique_ptr<sim::SimulatedBody> body_;
  std::unique_ptr<Navigator> navigator_;
  Twist command_;
  double driven_m_ = 0.0;
  double now_s_ = 0.0;
};

/// Returns how many times it has come by where the way closes, of a route of many loops. Who is off the way may take
/// a place for its like of a later loop: a loop that was not driven for at least half of its length does not count.
std::size_t loops_done(const Course& course, std::uint32_t route_at, double driven_m) {
  const std::size_t loop = course.places.size() - course.closes_at;
  const std::size_t passed = route_at < course.closes_at ? 0 : (route_at - course.closes_at) / loop;
  return std::min(passed, static_cast<std::size_t>(driven_m / (0.5 * course.round_m())));
}

void note(const Navigated& now, Repeated& repeated) {
  if (now.fix || !now.refusals.empty()) ++repeated.looks;
  repeated.learned_places.insert(repeated.learned_places.end(), now.learned_places.begin(), now.learned_places.end());
  if (!now.fix) return;
  ++repeated.fixes;
  repeated.votes += now.fix->evidence.inliers;
}

/// Drives the route to its end or until the robot stands. Returns false when it was stopped.
Result<bool> follow(Repeating& robot, const Drive& drive, const Course& course, std::size_t loops,
                    Repeated& repeated) {
  for (int stood = 0;;) {
    if (drive.asked_to_stop()) return false;
    const Result<Navigated> now = robot.step();
    if (!now) return fail(now.error());
    note(*now, repeated);
    const std::optional<Deviation> deviation = robot.deviation();
    if (deviation) repeated.along.push_back(*deviation);
    const bool arrived = now->following == Following::arrived;
    const std::size_t done =
        arrived ? loops : std::min(loops - 1, loops_done(course, now->route_at, robot.driven_m()));
    if (deviation && done > repeated.after_loop.size()) repeated.after_loop.push_back(*deviation);
    stood = now->command == Twist{} ? stood + 1 : 0;
    repeated.ended = now->lost ? "lost" : std::string(now->reason);
    if (arrived) {
      repeated.ended.clear();
      return true;
    }
    if (now->following == Following::failed || stood > kStandsAtMost || robot.now_s() > kLongestS) {
      if (repeated.ended.empty()) repeated.ended = "does not move on";
      return true;
    }
  }
}

}  // namespace

Result<std::unique_ptr<Navigator>> make_navigator(const CameraModel& camera, Parts parts) {
  Result<Bearing> method = Bearing::make({}, camera);
  if (!method) return fail(method.error());
  NavigationConfig config;
  if (parts == Parts::vision_only) {
    // What is seen counts alone, whatever the wheels say.
    config.belief.fuse = false;
    config.belief.gate_sigmas = 10.0;
    config.belief.gate_floor_rad = 0.5;
  }
  if (parts == Parts::all) return agents::make_navigator(std::move(*method), config);
  return agents::make_navigator(Ablated(std::move(*method), parts), config);
}

Result<std::optional<Repeated>> repeat(const Drive& drive, const Course& course, const Start& start,
                                       std::size_t loops, Parts parts) {
  auto body = sim::make_sim_body(drive.body);
  if (!body) return fail(body.error());
  auto navigator = make_navigator((*body)->rig().camera(), parts);
  if (!navigator) return fail(navigator.error());
  (*body)->put(course.site_from_place[start.place] * start.place_from_robot, {});
  Repeating robot(course, std::move(*body), std::move(*navigator));
  robot.navigator().seek(start.is_told ? std::optional(course.places[start.place]) : std::nullopt);
  Repeated repeated;
  for (int i = 0; !robot.navigator().estimate(); ++i) {
    if (drive.asked_to_stop()) return std::optional<Repeated>();
    if (i == kLookAtMost) {
      repeated.ended = "did not find itself";
      return std::optional(std::move(repeated));
    }
    if (const Result<Navigated> now = robot.step(); !now) return fail(now.error());
  }
  robot.navigator().follow(course.loops(loops));
  const Result<bool> driven = follow(robot, drive, course, loops, repeated);
  if (!driven) return fail(driven.error());
  if (!*driven) return std::optional<Repeated>();
  return std::optional(std::move(repeated));
}

}  // namespace weft::evaluate::bearing
