#include "clients/evaluate/bearing/relocalise/led.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "agents/navigation/agreement.hpp"

namespace weft::evaluate::bearing {

using namespace agents;

namespace {

constexpr int kExposes = 20;     // samples for the camera to find its exposure
constexpr int kStands = 8;       // samples before a robot is led
constexpr int kEndsAtMost = 10;  // samples for the last place
const RobotId kLedBy{{1}};

/// Leads one run. False: stopped.
Result<bool> teach_run(const Drive& drive, sim::SimulatedBody& body, Navigator& navigator, ExperienceId run,
                       const std::vector<SitePoint>& line, TaughtAisles& taught) {
  body.put({line[0].x, line[0].y, std::atan2(line[1].y - line[0].y, line[1].x - line[0].x)}, {});
  bool hand_done = false;
  const auto step = [&]() -> Result<Navigated> {
    const Result<Sample> sample = body.step({});
    if (!sample) return fail(sample.error());
    Navigated now = navigator.step(*sample, taught.map.view());
    expose(body, now);
    hand_done = sample->hand_done;
    return now;
  };
  for (int i = 0; i < kExposes; ++i)
    if (const auto looked = step(); !looked) return fail(looked.error());
  if (const Result<void> begun = body.drive_by_hand(line); !begun) return fail(begun.error());
  navigator.begin_teach({run, kLedBy});
  const auto take = [&](const std::vector<Kept>& kept) {
    for (const Kept& one : kept) taught.site_from_place[one.place.id] = body.site_from_robot();
    return taught.map.take(run, kLedBy, Bearing::name, kept);
  };
  int ending = 0;
  for (bool done = false; !done;) {
    if (drive.asked_to_stop()) return false;
    const Result<Navigated> now = step();
    if (!now) return fail(now.error());
    if (const Result<void> taken = take(now->kept); !taken) return fail(taken.error());
    if (!hand_done) continue;
    if (const Result<void> taken = take(navigator.end_teach(taught.map.view())); !taken) return fail(taken.error());
    done = !navigator.is_taught() || ++ending > kEndsAtMost;
  }
  return true;
}

std::string most_frequent(const std::map<std::string, std::size_t>& refusals) {
  const auto most = std::max_element(refusals.begin(), refusals.end(),
                                     [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == refusals.end() ? "" : most->first;
}

void judge_belief(const Estimate& believed, const TaughtAisles& taught, const Pose2& site_from_robot, Led& led) {
  const Pose2 truth = taught.site_from_place.at(believed.place).inverse() * site_from_robot;
  const Pose2 said = planar(believed.place_from_robot);
  led.along_m = said.x - truth.x;
  led.aside_m = truth.y - said.y;
  led.turned_rad = wrap_angle(said.heading - truth.heading);
  led.sigma_m = spread_of(believed.place_from_robot).metres;
}

}  // namespace

bool is_right(const Led& led) {
  return std::abs(led.along_m) <= kRightAlongM && std::abs(led.aside_m) <= kRightAsideM &&
         std::abs(led.turned_rad) <= kRightRad;
}

Result<std::optional<TaughtAisles>> teach(const Drive& drive, const Aisles& aisles) {
  auto body = sim::make_sim_body(drive.body);
  if (!body) return fail(body.error());
  TaughtAisles taught;
  for (const std::size_t aisle : aisles.taught()) {
    // A robot that is switched on in each aisle: it does not know where it is until it finds out.
    auto navigator = make_navigator((*body)->rig().camera(), Parts::all);
    if (!navigator) return fail(navigator.error());
    const Result<bool> done =
        teach_run(drive, **body, **navigator, ExperienceId{aisle + 1}, aisles.line(aisle), taught);
    if (!done) return fail(done.error());
    if (!*done) return std::optional<TaughtAisles>();
  }
  return std::optional(std::move(taught));
}

Result<Leading> Leading::make(const Drive& drive) {
  auto body = sim::make_sim_body(drive.body);
  if (!body) return fail(body.error());
  return Leading(std::move(*body), drive.asked_to_stop);
}

Result<std::optional<Led>> Leading::lead(const PutDown& put_down, const TaughtAisles& taught) {
  Led led;
  led.site_from_robot = put_down.site_from_robot;
  body_->put(put_down.site_from_robot, {});
  auto navigator = make_navigator(body_->rig().camera(), Parts::all);
  if (!navigator) return fail(navigator.error());
  (*navigator)->seek(std::nullopt);
  std::map<std::string, std::size_t> refusals;
  double led_m = 0.0;
  bool is_led = false;
  for (int i = 0;; ++i) {
    if (asked_to_stop_()) return std::optional<Led>();
    if (i == kStands) {
      if (const Result<void> begun = body_->drive_by_hand(put_down.way); !begun) return fail(begun.error());
      is_led = true;
    }
    const Pose2 before = body_->site_from_robot();
    const Result<Sample> sample = body_->step({});
    if (!sample) return fail(sample.error());
    const Navigated now = (*navigator)->step(*sample, taught.map.view());
    expose(*body_, now);
    led_m += (before.inverse() * body_->site_from_robot()).translation().norm();
    for (const Refusal& refusal : now.refusals) ++refusals[std::string(refusal.reason)];
    if (const std::optional<Estimate> believed = (*navigator)->estimate()) {
      led.found_m = led_m;
      judge_belief(*believed, taught, body_->site_from_robot(), led);
      return std::optional(led);
    }
    if (is_led && sample->hand_done) break;
  }
  led.refused = most_frequent(refusals);
  return std::optional(led);
}

}  // namespace weft::evaluate::bearing
