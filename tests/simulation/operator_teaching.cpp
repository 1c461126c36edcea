#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/simulation/operator.hpp"
#include "tests/simulation/ways_by_hand.hpp"

namespace weft::simulation {

bool Operator::teach_piece(std::size_t robot, double from_m, double to_m, const std::vector<std::size_t>& through) {
  msg::OperatorRequest request;
  request.kind = msg::OperatorRequest::Kind::teach_start;
  request.robot = fleet_.name(robot);
  request.label = "lap-" + fleet_.name(robot);
  for (const auto& point : fleet_.site().line(from_m, to_m, through)) request.along.push_back({point.x, point.y});
  auto reply = ask(request);
  // One lost word of an idle robot is six seconds of silence: people try again.
  for (int again = 0; again < 3 && reply && reply->message.find("is not heard") != std::string::npos; ++again) {
    pass(std::chrono::seconds(5));
    reply = ask(request);
  }
  if (!reply || reply->outcome == msg::Outcome::refused || reply->outcome == msg::Outcome::failed) {
    return give_up("teach " + fleet_.name(robot), reply);
  }
  const bool over = wait(60.0 + 4.0 * (to_m - from_m), [&] { return !fleet_.body(robot).by_hand(); });
  if (over && fleet_.robot_up(robot) && fleet_.state(robot).mode == msg::RobotMode::teaching) return true;
  trouble_ = fleet_.name(robot) + " is " + to_string(fleet_.state(robot).mode) + ": " + fleet_.state(robot).reason;
  return false;
}

bool Operator::teach_lesson(std::size_t robot) {
  const Course& course = fleet_.site().course();
  struct Spot {
    double at_m;
    std::string label;
    std::optional<std::size_t> station;
  };
  const Lesson lesson = course.lesson(robot, fleet_.robots());
  const auto ahead = [&](double at_m) {
    return lesson.from_m + std::fmod(at_m - lesson.from_m + 2.0 * course.length_m(), course.length_m());
  };
  std::vector<Spot> spots;
  for (const std::size_t k : lesson.through)
    spots.push_back({ahead(course.stations()[k].at_m), "station-" + std::to_string(k), k});
  for (std::size_t i = 1; i < fleet_.robots(); ++i) {
    const double at_m = ahead(course.start_m(i, fleet_.robots()));
    if (i == robot || at_m > lesson.to_m || !starts_.insert(i).second) continue;
    spots.push_back({at_m, "start-" + std::to_string(i), {}});
  }
  std::sort(spots.begin(), spots.end(), [](const Spot& a, const Spot& b) { return a.at_m < b.at_m; });
  spots.push_back({lesson.to_m, "", {}});

  double at = lesson.from_m;
  std::vector<msg::OperatorRequest> labels;
  for (const Spot& spot : spots) {
    if (!teach_piece(robot, at, spot.at_m, lesson.through)) return false;
    at = spot.at_m;
    if (spot.label.empty()) continue;
    if (!label_here(robot, spot.label, labels)) return false;
    if (spot.station) stations_[spot.label] = *spot.station;
  }
  msg::OperatorRequest stop;
  stop.kind = msg::OperatorRequest::Kind::teach_stop;
  stop.robot = fleet_.name(robot);
  const auto reply = ask(stop);
  if (!reply || reply->outcome != msg::Outcome::done) return give_up("teach stop", reply);
  for (const msg::OperatorRequest& label : labels) {
    const auto named = repeat(label, 120.0);
    if (!named || named->outcome != msg::Outcome::done) return give_up("label " + label.label, named);
  }
  return true;
}

bool Operator::label_here(std::size_t robot, const std::string& label, std::vector<msg::OperatorRequest>& open) {
  constexpr double until_kept_s = 6.0;
  msg::OperatorRequest request;
  request.kind = msg::OperatorRequest::Kind::label_here;
  request.robot = fleet_.name(robot);
  request.label = label;
  if (!Fleet::refines(robot)) {
    const auto reply = ask(request);
    return (reply && reply->outcome == msg::Outcome::done) || give_up("label " + label, reply);
  }
  request.request = random_.next();
  if (const auto reply = repeat(request, until_kept_s)) return give_up("label " + label + " of a draft", reply);
  open.push_back(request);
  return true;
}

bool Operator::teach_all() {
  for (std::size_t robot = 0; robot < fleet_.robots(); ++robot) {
    if (robot > 0) {
      msg::OperatorRequest localise;
      localise.kind = msg::OperatorRequest::Kind::localise;
      localise.robot = fleet_.name(robot);
      localise.label = "start-" + std::to_string(robot);
      const auto reply = ask(localise);
      if (!reply || !wait(120.0, [&] { return fleet_.state(robot).localised; })) {
        return give_up("localise " + fleet_.name(robot), reply);
      }
    }
    if (!teach_lesson(robot)) return false;
  }
  return true;
}

/// Tells every robot where it stands on the stored map, again until it knows.
bool Operator::find_all() {
  constexpr int most_rounds = 20;
  for (int round = 0; round < most_rounds; ++round) {
    std::optional<std::size_t> last;
    for (std::size_t robot = 0; robot < fleet_.robots(); ++robot) {
      if (fleet_.state(robot).localised) continue;
      last = robot;
      find_at(robot, "start-" + std::to_string(robot));
    }
    if (!last) break;
    pass(std::chrono::seconds(5));
    if (round + 1 == most_rounds) return give_up("localise " + fleet_.name(*last), std::nullopt);
  }
  const Course& course = fleet_.site().course();
  for (std::size_t k = 0; k < course.stations().size(); ++k) stations_["station-" + std::to_string(k)] = k;
  return true;
}

bool Operator::begin(MapFrom map) {
  pass(std::chrono::seconds(45));  // until everybody has been heard
  if (!(map == MapFrom::stored ? find_all() : teach_all())) return false;
  for (std::size_t robot = 0; robot < fleet_.robots(); ++robot) send_goal(free_station(), fleet_.name(robot));
  return true;
}

void Operator::teach_stop(std::size_t robot) {
  msg::OperatorRequest stop;
  stop.kind = msg::OperatorRequest::Kind::teach_stop;
  stop.robot = fleet_.name(robot);
  ask(stop);
}

/// Returns whether a hand may lead the robot along the line: never into another one, nor nearer to one that is close
/// already; into the way of another one, perhaps.
bool Operator::is_clear(std::size_t robot, const std::vector<agents::SitePoint>& line, bool leaving) const {
  constexpr double room_m = 1.5;
  constexpr double leaving_m = 1.0;
  for (std::size_t other = 0; other < fleet_.robots(); ++other) {
    const Pose2& there = fleet_.body(other).site_from_robot();
    const auto away = [&](const agents::SitePoint& point) {
      return std::hypot(point.x - there.x, point.y - there.y);
    };
    const double room = leaving ? std::min(leaving_m, away(line.front()) - 0.05) : room_m;
    const bool is_near =
        std::any_of(line.begin(), line.end(), [&](const agents::SitePoint& point) { return away(point) < room; });
    if (other != robot && is_near) return false;
  }
  return true;
}

/// Leads an idle robot by hand a few metres along the course, teaching.
bool Operator::teach_more(std::size_t robot) {
  if (fleet_.state(robot).mode != msg::RobotMode::idle || !fleet_.state(robot).localised) return false;
  const Site& site = fleet_.site();
  const auto [at, through] = site.nearest(fleet_.body(robot).site_from_robot());
  const double to = at + random_.uniform(3.0, 9.0);
  if (!is_clear(robot, site.line(at, to, through), false)) return false;
  teach_piece(robot, at, to, through);
  if (fleet_.robot_up(robot) && fleet_.state(robot).mode == msg::RobotMode::teaching) teach_stop(robot);
  return true;
}

/// Turns an idle robot by hand, takes it to a free siding, around whoever stands near, and tells it where that is.
void Operator::take_away(std::size_t robot) {
  constexpr double before_m = 3.5;  // along the siding, so that it stands as it was taught there
  if (!is_idle(robot)) return;
  const Site& site = fleet_.site();
  for (const std::string& label : free_stations()) {
    const std::size_t station = stations_.at(label);
    if (site.course().stations()[station].right_m == 0.0) continue;  // there it would stand in the way
    const double at = site.course().stations()[station].at_m;
    const std::vector<agents::SitePoint> last = site.line(at - before_m, at, {station});
    for (const double turned : {std::numbers::pi, std::numbers::pi / 2.0, -std::numbers::pi / 2.0, 0.0}) {
      const Pose2 here = fleet_.body(robot).site_from_robot() * Pose2{0.0, 0.0, turned};
      for (std::vector<agents::SitePoint> way : ways_by_hand(here, site.pose(at - before_m, {station}))) {
        way.insert(way.end(), last.begin() + 1, last.end());
        if (!is_clear(robot, way, true) || !fleet_.take_by_hand(robot, way)) continue;
        wait(200.0, [&] { return !fleet_.body(robot).by_hand(); });
        fleet_.let_go(robot);
        return find_at(robot, label);
      }
    }
  }
}

void Operator::find_at(std::size_t robot, const std::string& label) {
  msg::OperatorRequest localise;
  localise.kind = msg::OperatorRequest::Kind::localise;
  localise.robot = fleet_.name(robot);
  localise.label = label;
  ask(localise);
}

}  // namespace weft::simulation
