#include "clients/evaluate/floor/drive.hpp"

#include <string>
#include <utility>

#include "agents/navigation/run_refiner.hpp"
#include "clients/evaluate/floor/driven_robot.hpp"
#include "clients/evaluate/floor/refined_draft.hpp"

namespace weft::evaluate::floor {
namespace {

using namespace agents;

constexpr int kLookAtMost = 120;      // samples standing, until it is given up as not localised
constexpr int kStandsAtMost = 120;    // samples on its way without moving on: at rest two a second
constexpr int kRestsFor = 4;          // samples after arriving, for the base to come to rest
constexpr int kLastViewAtMost = 10;   // samples for the last place
constexpr double kLongestS = 1800.0;  // of a repeat, on the simulation's clock

/// Lets the robot look until it believes to know where it is. None: stopped; false: it did not find out.
Result<std::optional<bool>> find_itself(DrivenRobot& robot, const Drive& drive, const Taught& taught) {
  robot.navigator().seek(std::nullopt);
  for (int i = 0; i < kLookAtMost; ++i) {
    if (drive.asked_to_stop()) return std::optional<bool>();
    const Result<DrivenRobot::Stepped> stepped = robot.step(taught.map.view());
    if (!stepped) return fail(stepped.error());
    if (robot.navigator().estimate()) return std::optional(true);
  }
  return std::optional(false);
}

/// Drives the route until the robot rests at its end or gives up. Returns false when it was stopped.
Result<bool> follow(DrivenRobot& robot, const Drive& drive, const Taught& taught, Repeated& repeated) {
  int stood = 0;
  int rested = 0;
  while (rested < kRestsFor) {
    if (drive.asked_to_stop()) return false;
    const Result<DrivenRobot::Stepped> stepped = robot.step(taught.map.view());
    if (!stepped) return fail(stepped.error());
    const Navigated& now = stepped->navigated;
    repeated.arrived = now.following == Following::arrived;
    if (repeated.arrived) ++rested;
    stood = now.command == Twist{} ? stood + 1 : 0;
    repeated.ended = now.lost ? "lost" : std::string(now.reason);
    const bool gives_up = now.following == Following::failed || stood > kStandsAtMost || robot.now_s() > kLongestS;
    if (!repeated.arrived && gives_up) break;
  }
  if (repeated.arrived) repeated.ended.clear();
  return true;
}

}  // namespace

Result<std::optional<Trace>> lead(const Drive& drive, const std::vector<SitePoint>& line) {
  Result<DrivenRobot> robot = DrivenRobot::make(drive.body, drive.camera, drive.navigator);
  if (!robot) return fail(robot.error());
  if (const Result<void> begun = robot->body().drive_by_hand(line); !begun) return fail(begun.error());
  const TaughtMap nothing;
  for (bool done = false; !done;) {
    if (drive.asked_to_stop()) return std::optional<Trace>();
    const Result<DrivenRobot::Stepped> stepped = robot->step(nothing.view());
    if (!stepped) return fail(stepped.error());
    done = stepped->hand_done;
  }
  Result<Trace> trace = robot->finish();
  if (!trace) return fail(trace.error());
  return std::optional(std::move(*trace));
}

Result<bool> teach(const Drive& drive, const std::vector<SitePoint>& line, Taught& taught) {
  const ExperienceId experience{taught.traces.size() + 1};
  const RobotId teacher{{static_cast<std::uint8_t>(experience.value)}};
  Result<DrivenRobot> robot = DrivenRobot::make(drive.body, drive.camera, drive.navigator);
  if (!robot) return fail(robot.error());
  const TaughtMap before = taught.map;
  const std::string method(robot->navigator().method());
  const bool refines = robot->navigator().refiner(method) != nullptr;
  std::vector<Kept> draft;  // empty: nothing is refined
  if (!taught.traces.empty()) {
    const Result<std::optional<bool>> found = find_itself(*robot, drive, taught);
    if (!found) return fail(found.error());
    if (!*found) return false;
    if (!**found) return fail(ErrorCode::refused, "a robot that is to be taught more does not find where it is");
  }
  if (const Result<void> begun = robot->body().drive_by_hand(line); !begun) return fail(begun.error());
  robot->navigator().begin_teach({experience, teacher});
  const auto take = [&](const std::vector<Kept>& kept) {
    if (!kept.empty()) taught.last = kept.back().place.id;
    if (refines) draft.insert(draft.end(), kept.begin(), kept.end());
    return taught.map.take(experience, teacher, method, kept);
  };
  int ending = 0;
  for (bool done = false; !done;) {
    if (drive.asked_to_stop()) return false;
    const Result<DrivenRobot::Stepped> stepped = robot->step(taught.map.view());
    if (!stepped) return fail(stepped.error());
    if (const Result<void> taken = take(stepped->navigated.kept); !taken) return fail(taken.error());
    if (stepped->hand_done) ++ending;
    done = (ending > 0 && stepped->has_view) || ending > kLastViewAtMost;
  }
  const std::vector<Kept> kept = robot->navigator().end_teach(taught.map.view());
  robot->note_last(kept);
  if (const Result<void> taken = take(kept); !taken) return fail(taken.error());
  const Result<std::optional<std::vector<Kept>>> refined = refined_draft(robot->navigator(), draft);
  if (!refined) return fail(refined.error());
  taught.refined = refined->has_value();
  if (taught.refined) {
    taught.map = before;
    if (const Result<void> taken = taught.map.take(experience, teacher, method, **refined); !taken)
      return fail(taken.error());
  }
  Result<TeachReport> way = robot->navigator().teach_report();
  if (!way && way.error().code != ErrorCode::refused) return fail(way.error());
  taught.way = way ? std::move(*way) : TeachReport{};
  Result<Trace> trace = robot->finish();
  if (!trace) return fail(trace.error());
  const PlaceSet places = places_of(*trace);
  taught.places.site_from_place.insert(places.site_from_place.begin(), places.site_from_place.end());
  taught.places.start_from_place.insert(places.start_from_place.begin(), places.start_from_place.end());
  taught.traces.push_back(std::move(*trace));
  return true;
}

Result<std::optional<Repeated>> repeat(const Drive& drive, const Taught& taught) {
  Result<DrivenRobot> robot = DrivenRobot::make(drive.body, drive.camera, drive.navigator);
  if (!robot) return fail(robot.error());
  Repeated repeated;
  const Result<std::optional<bool>> found = find_itself(*robot, drive, taught);
  if (!found) return fail(found.error());
  if (!*found) return std::optional<Repeated>();
  repeated.localised = **found;
  repeated.ended = "did not find itself";
  if (repeated.localised) {
    const Result<Route> route =
        taught.map.route(robot->navigator().estimate()->place, taught.last, robot->navigator().method());
    if (!route) return fail(route.error());
    robot->navigator().follow(*route);
    const Result<bool> driven = follow(*robot, drive, taught, repeated);
    if (!driven) return fail(driven.error());
    if (!*driven) return std::optional<Repeated>();
  }
  Result<Trace> trace = robot->finish();
  if (!trace) return fail(trace.error());
  repeated.trace = std::move(*trace);
  return std::optional(std::move(repeated));
}

}  // namespace weft::evaluate::floor
