#include "tests/bench/traffic/play.hpp"

#include <cmath>
#include <limits>

namespace weft::bench {
namespace {

using server::test::goal_id;
using server::test::Handed;
using server::test::robot_id;

constexpr double kSpacing_m = 0.5;
constexpr double kOneFloor_m = 0.3;
constexpr double kAlike_rad = 0.3;
constexpr double kSaid_s = 0.2;  // robots say five times a second where they are
constexpr double kDriven_m = 0.6 * kSaid_s;

std::vector<Pose2> along(const std::vector<Eigen::Vector2d>& corners) {
  std::vector<Pose2> poses;
  for (std::size_t i = 1; i < corners.size(); ++i) {
    const Eigen::Vector2d side = corners[i] - corners[i - 1];
    const int places = std::max(1, static_cast<int>(std::lround(side.norm() / kSpacing_m)));
    for (int k = 0; k < places + (i + 1 == corners.size() ? 1 : 0); ++k) {
      const Eigen::Vector2d at = corners[i - 1] + side * k / places;
      poses.push_back({at.x(), at.y(), std::atan2(side.y(), side.x())});
    }
  }
  return poses;
}

Edge joining(const PlaceId& a, const Pose2& at_a, const PlaceId& b, const Pose2& at_b) {
  Edge edge;
  edge.id = {a, b};
  edge.a_from_b = Metric2{at_a.inverse() * at_b, 1e-5 * Eigen::Matrix3d::Identity()};
  edge.method = "marks";
  return edge;
}

}  // namespace

Play::Play() {
  site_.hello(teacher_);
}

ExperienceId Play::teach(const std::vector<Eigen::Vector2d>& corners) {
  const ExperienceId run{++runs_};
  const std::vector<Pose2> poses = along(corners);
  server::test::TaughtRun made(teacher_, run.value);
  Handed handed = made.next(static_cast<std::uint32_t>(poses.size()), 10);
  const std::map<PlaceId, Pose2> before = poses_;
  for (std::uint32_t i = 0; i < poses.size(); ++i) {
    const PlaceId id{run, i};
    if (i > 0) handed.batch.edges[i - 1].a_from_b = joining({run, i - 1}, poses[i - 1], id, poses[i]).a_from_b;
    poses_[id] = poses[i];
  }
  for (std::uint32_t i = 0; i < poses.size(); ++i) {
    const auto stitch_to = [&](const PlaceId& other, const Pose2& at) {
      const Pose2 between = at.inverse() * poses[i];
      if (between.translation().norm() > kOneFloor_m || std::abs(between.heading) > kAlike_rad) return;
      Edge stitch = server::test::stitch(other, {run, i});
      stitch.drivable = Drivable::both;
      stitch.a_from_b = joining(other, at, {run, i}, poses[i]).a_from_b;
      handed.batch.edges.push_back(stitch);
    };
    for (const auto& [other, at] : before) stitch_to(other, at);
    // Where the run comes by its own beginning.
    for (std::uint32_t k = 0; k + 4 < i; ++k) stitch_to({run, k}, poses[k]);
  }
  site_.hand_in(teacher_, handed);
  return run;
}

PlaceId Play::near(ExperienceId run, const Eigen::Vector2d& at) const {
  PlaceId nearest;
  double least_m = std::numeric_limits<double>::max();
  for (const auto& [place, pose] : poses_) {
    const double apart_m = (pose.translation() - at).norm();
    if (place.experience != run || apart_m >= least_m) continue;
    least_m = apart_m;
    nearest = place;
  }
  return nearest;
}

void Play::put(const std::string& robot, const PlaceId& place) {
  const auto [entry, is_new] = robots_.try_emplace(robot);
  Puppet& puppet = entry->second;
  puppet.at = place;
  if (!is_new) return;
  puppet.peer.id = robot_id(static_cast<std::uint8_t>(robots_.size()));
  puppet.peer.name = robot;
  site_.arrive(puppet.peer, place);
}

void Play::close(const std::string& rule, const PlaceId& first, const PlaceId& last) {
  msg::OperatorRequest request = site_.request(msg::OperatorRequest::Kind::rule_put);
  request.rule = {.name = rule, .spans = {{first, last}}};
  site_.ask(request);
}

void Play::open(const std::string& rule) {
  msg::OperatorRequest request = site_.request(msg::OperatorRequest::Kind::rule_remove);
  request.rule.name = rule;
  site_.ask(request);
}

void Play::send(const std::string& robot, const std::string& label) {
  site_.send_goal(++goals_, label, robot);
}

void Play::pass(double seconds) {
  const SteadyTime end = site_.now.steady + from_seconds(seconds);
  while (site_.now.steady < end) step();
}

bool Play::play(double seconds) {
  const SteadyTime end = site_.now.steady + from_seconds(seconds);
  while (site_.now.steady < end && !all_over()) step();
  return all_over();
}

std::vector<std::string> Play::open_goals() {
  std::vector<std::string> causes;
  for (std::uint8_t number = 1; number <= goals_; ++number) {
    const Goal& goal = site_.goal(number);
    if (!is_terminal(goal.state)) causes.push_back(goal.history.back().cause);
  }
  return causes;
}

bool Play::all_over() {
  for (std::uint8_t number = 1; number <= goals_; ++number) {
    if (!is_terminal(site_.goal(number).state)) return false;
  }
  return true;
}

double Play::now_s() const {
  return seconds(site_.now.steady.time_since_epoch());
}

void Play::step() {
  take_orders();
  for (auto& [name, robot] : robots_) {
    if (robot.is_alive) drive(robot);
  }
  site_.pass(from_seconds(kSaid_s));
  if (!named_after_s_ && !named().empty()) named_after_s_ = now_s() - moved_s_;
}

void Play::take_orders() {
  const std::vector<msg::RouteOrder> orders = site_.heard<msg::RouteOrder>();
  site_.hush();
  for (const msg::RouteOrder& order : orders) {
    for (auto& [name, robot] : robots_) {
      if (robot.peer.id != order.to) continue;
      const bool is_known = robot.route && robot.route->id == order.route.id;
      if (order.route.ended) {
        if (is_known) robot.route.reset();
        continue;
      }
      const bool is_news = !is_known || order.route.version > robot.route->version;
      // A version begins with all that was released before it.
      if (!is_known) robot.index = 0;
      if (is_news || order.route.released > robot.route->released) robot.route = order.route;
    }
  }
}

void Play::drive(Puppet& robot) {
  msg::RobotState state = site_.state(robot.peer, robot.at);
  if (robot.route) {
    Route& route = *robot.route;
    const bool moves = robot.index < route.released;
    if (moves) {
      moved_s_ = now_s();
      robot.driven_m += kDriven_m;
    }
    if (robot.driven_m >= kSpacing_m) {
      robot.driven_m -= kSpacing_m;
      ++robot.index;
    }
    robot.at = route.places[robot.index];
    const bool has_arrived = robot.index + 1 == route.places.size();
    site_.progress(robot.peer, route,
                   has_arrived ? msg::RoutePhase::arrived
                   : moves     ? msg::RoutePhase::driving
                               : msg::RoutePhase::waiting,
                   robot.index > 0 ? robot.index - 1 : 0, robot.index);
    state = site_.state(robot.peer, robot.at);
    state.route = route.id;
    state.route_version = route.version;
    state.goal = route.goal;
    state.mode = moves ? msg::RobotMode::driving : msg::RobotMode::waiting;
  }
  site_.say(state);
}

}  // namespace weft::bench
