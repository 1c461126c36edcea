#include <algorithm>
#include <cmath>

#include "tests/simulation/operator.hpp"

namespace weft::simulation {

bool Operator::teach_piece(std::size_t robot, double from_m, double to_m, const std::vector<std::size_t>& through) {
  msg::OperatorRequest request;
  request.kind = msg::OperatorRequest::Kind::teach_start;
  request.robot = fleet_.name(robot);
  request.label = "lap-" + fleet_.name(robot);
  for (const auto& point : fleet_.site().line(from_m, to_m, through)) request.along.push_back({point.x, point.y});
  const auto reply = ask(request);
  if (!reply || reply->outcome == msg::Outcome::refused || reply->outcome == msg::Outcome::failed) {
    return give_up("teach " + fleet_.name(robot), reply);
  }
  const bool over = wait(60.0 + 4.0 * (to_m - from_m), [&] { return !fleet_.body(robot).by_hand(); });
  if (over && fleet_.robot_up(robot) && fleet_.state(robot).mode == msg::RobotMode::teaching) return true;
  trouble_ = fleet_.name(robot) + " is " + to_string(fleet_.state(robot).mode) + ": " + fleet_.state(robot).reason;
  return false;
}

bool Operator::teach_lap(std::size_t robot) {
  const RingSite& site = fleet_.site();
  const auto start_of = [&](std::size_t i) {
    return 9.0 + static_cast<double>(i) * site.length_m() / static_cast<double>(fleet_.robots());
  };
  struct Spot {
    double at_m;
    std::string label;
    std::optional<std::size_t> station;
  };
  std::vector<std::size_t> through;
  std::vector<Spot> spots;
  const double begin = start_of(robot);
  const auto ahead = [&](double at_m) {
    return begin + std::fmod(at_m - begin + 2.0 * site.length_m(), site.length_m());
  };
  for (std::size_t k = robot; k < site.stations(); k += fleet_.robots()) {
    through.push_back(k);
    spots.push_back({ahead(site.station_m(k)), "station-" + std::to_string(k), k});
  }
  for (std::size_t i = 1; robot == 0 && i < fleet_.robots(); ++i)
    spots.push_back({start_of(i), "start-" + std::to_string(i), {}});
  std::sort(spots.begin(), spots.end(), [](const Spot& a, const Spot& b) { return a.at_m < b.at_m; });
  spots.push_back({begin + site.length_m() + 1.5, "", {}});

  double at = begin;
  for (const Spot& spot : spots) {
    if (!teach_piece(robot, at, spot.at_m, through)) return false;
    at = spot.at_m;
    if (spot.label.empty()) continue;
    msg::OperatorRequest label;
    label.kind = msg::OperatorRequest::Kind::label_here;
    label.robot = fleet_.name(robot);
    label.label = spot.label;
    const auto reply = ask(label);
    if (!reply || reply->outcome != msg::Outcome::done) return give_up("label " + spot.label, reply);
    if (spot.station) stations_[spot.label] = *spot.station;
  }
  msg::OperatorRequest stop;
  stop.kind = msg::OperatorRequest::Kind::teach_stop;
  stop.robot = fleet_.name(robot);
  const auto reply = ask(stop);
  return (reply && reply->outcome == msg::Outcome::done) || give_up("teach stop", reply);
}

bool Operator::teach_all() {
  pass(std::chrono::seconds(45));  // until everybody has been heard
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
    if (!teach_lap(robot)) return false;
  }
  for (std::size_t robot = 0; robot < fleet_.robots(); ++robot) send_goal(free_station(), fleet_.name(robot));
  return true;
}

void Operator::teach_stop(std::size_t robot) {
  msg::OperatorRequest stop;
  stop.kind = msg::OperatorRequest::Kind::teach_stop;
  stop.robot = fleet_.name(robot);
  ask(stop);
}

/// Nobody drives a robot into another one; into the way of another one, perhaps.
bool Operator::is_clear(std::size_t robot, const std::vector<agents::SitePoint>& line) const {
  constexpr double room_m = 1.5;
  for (std::size_t other = 0; other < fleet_.robots(); ++other) {
    const Pose2& there = fleet_.body(other).site_from_robot();
    const bool is_near = std::any_of(line.begin(), line.end(), [&](const agents::SitePoint& point) {
      return std::hypot(point.x - there.x, point.y - there.y) < room_m;
    });
    if (other != robot && is_near) return false;
  }
  return true;
}

/// A hand takes an idle robot a few metres along the ring, teaching.
void Operator::teach_more(std::size_t robot) {
  if (fleet_.state(robot).mode != msg::RobotMode::idle || !fleet_.state(robot).localised) return;
  const RingSite& site = fleet_.site();
  const Pose2& here = fleet_.body(robot).site_from_robot();
  double best = 1e9;
  double at = 0.0;
  std::vector<std::size_t> through;
  for (double along = 0.0; along < site.length_m(); along += 0.1) {
    for (std::size_t k = 0; k <= site.stations(); ++k) {
      const std::vector<std::size_t> way = k < site.stations() ? std::vector{k} : std::vector<std::size_t>{};
      const double away = (site.pose(along, way).translation() - here.translation()).norm();
      if (away < best) {
        best = away;
        at = along;
        through = way;
      }
    }
  }
  const double to = at + random_.uniform(3.0, 9.0);
  if (!is_clear(robot, site.line(at, to, through))) return;
  teach_piece(robot, at, to, through);
  if (fleet_.robot_up(robot) && fleet_.state(robot).mode == msg::RobotMode::teaching) teach_stop(robot);
}

}  // namespace weft::simulation
