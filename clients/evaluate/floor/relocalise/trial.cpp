#include "clients/evaluate/floor/relocalise/trial.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "agents/navigation/navigator_of.hpp"
#include "clients/evaluate/floor/attempts/tally.hpp"
#include "clients/evaluate/floor/scenario.hpp"
#include "clients/evaluate/line.hpp"

namespace weft::evaluate::floor {
namespace {

using namespace agents;

constexpr double kAsideM = 0.05;  // standard deviation
constexpr double kAskewRad = 0.07;

/// Returns whether what the robot believes is right of where it truly is.
bool is_found_rightly(const Estimate& believed, const Taught& taught, const Pose2& site_from_robot) {
  const Pose2 truth = taught.places.site_from_place.at(believed.place).inverse() * site_from_robot;
  return is_right(planar(believed.place_from_robot), truth);
}

std::string most_frequent(const std::map<std::string, std::size_t>& refusals) {
  const auto most = std::max_element(refusals.begin(), refusals.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == refusals.end() ? "" : most->first;
}

}  // namespace

const char* name_of(Along along) {
  return along == Along::forwards ? "forwards" : "backwards";
}

Push some_push(const std::vector<SitePoint>& line, Along along, Random& random) {
  constexpr double kLongerM = kPushM + 0.5;  // the hand slows down before its end
  const double from_m = random.uniform(0.0, length_of(line) - kLongerM);
  Push push{along, {}, stretch(line, from_m, from_m + kLongerM)};
  if (along == Along::backwards) std::reverse(push.way.begin(), push.way.end());
  const SitePoint& a = push.way[0];
  const SitePoint& b = push.way[1];
  const Pose2 on_line{a.x, a.y, std::atan2(b.y - a.y, b.x - a.x)};
  push.site_from_robot = on_line * Pose2{0.0, kAsideM * random.normal(), kAskewRad * random.normal()};
  return push;
}

Result<Pushed> Pushed::make(const Drive& drive) {
  sim::SimBodyConfig config = drive.body;
  config.truth_path.reset();
  Result<std::unique_ptr<sim::SimulatedBody>> body = sim::make_sim_body(config);
  if (!body) return fail(body.error());
  Result<Floor> method = Floor::make(FloorConfig{}, (*body)->rig().camera());
  if (!method) return fail(method.error());
  return Pushed(std::move(*body), std::move(*method), drive.asked_to_stop);
}

Result<void> Pushed::learn(const Taught& taught) {
  return known_.learn(method_, taught.map);
}

Result<std::optional<Trial>> Pushed::push(const Push& push, const Taught& taught) {
  Trial trial;
  trial.along = push.along;
  trial.site_from_robot = push.site_from_robot;
  body_->put(push.site_from_robot, {});
  if (const Result<void> led = body_->drive_by_hand(push.way); !led) return fail(led.error());
  const std::unique_ptr<Navigator> navigator = make_navigator(method_, NavigationConfig{});
  navigator->seek(std::nullopt);
  std::map<std::string, std::size_t> refusals;
  Pose2 before = push.site_from_robot;
  for (double pushed_m = 0.0; pushed_m < kPushM;) {
    if (asked_to_stop_()) return std::optional<Trial>();
    const Result<Sample> sample = body_->step({});
    if (!sample) return fail(sample.error());
    const Navigated now = navigator->step(*sample, taught.map.view());
    const Pose2 truth = body_->site_from_robot();
    pushed_m += (before.inverse() * truth).translation().norm();
    before = truth;
    known_.answer(*navigator, taught.map);
    for (const Refusal& refusal : now.refusals) ++refusals[std::string(refusal.reason)];
    if (const std::optional<Estimate> believed = navigator->estimate()) {
      trial.found_m = pushed_m;
      trial.is_wrong = !is_found_rightly(*believed, taught, truth);
      return std::optional(trial);
    }
    if (sample->hand_done) break;
  }
  trial.refused = most_frequent(refusals);
  return std::optional(trial);
}

}  // namespace weft::evaluate::floor
