#include "tests/bench/traffic/load.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/random.hpp"
#include "tests/bench/traffic/fleet.hpp"
#include "tests/bench/traffic/reporting_point.hpp"

namespace weft::bench {
namespace {

constexpr double kSettling_s = 60.0;  // in which the server learns where all places lie
constexpr double kStanding_s = 20.0;  // in which routes for what the robots can drive are prepared
constexpr double kWarmUp_s = 60.0;
constexpr double kBetweenGoals_s = 1.0;
constexpr std::uint32_t kStationsOfRobot = 2;
constexpr std::size_t kOperator = 65'002;

GoalId load_goal_id(std::uint64_t number) {
  GoalId id;
  id.bytes[0] = 1;
  for (std::size_t i = 0; i < sizeof(number); ++i) id.bytes[i + 1] = static_cast<std::uint8_t>(number >> (8 * i));
  return id;
}

/// Sends goals: one for any robot whenever one has ended, so that there are as many as robots.
class BusyOperator {
 public:
  BusyOperator(Served& served, std::vector<PlaceId> stations, Random random)
      : served_(served), stations_(std::move(stations)), random_(random) {
    for (std::size_t i = 0; i < stations_.size(); ++i) {
      msg::OperatorRequest label = request(msg::OperatorRequest::Kind::label);
      label.label = name_of(i);
      label.place = stations_[i];
      served_.handle(label);
    }
  }

  void keep_open(std::size_t goals) {
    std::set<std::string> led_to;
    for (const auto& [id, goal] : served_.disk().goals) {
      const bool is_open = goal.kind == GoalKind::operator_asked && !is_terminal(goal.state);
      if (is_open) led_to.insert(goal.label);
    }
    for (std::size_t open = led_to.size(); open < goals; ++open) {
      std::string to;
      while (to.empty() || led_to.contains(to)) to = name_of(random_.below(stations_.size()));
      led_to.insert(to);
      msg::OperatorRequest send = request(msg::OperatorRequest::Kind::goal_send);
      send.goal = load_goal_id(++sent);
      send.label = to;
      served_.handle(send);
    }
  }

  std::uint64_t sent = 0;

 private:
  static std::string name_of(std::size_t station) { return "station-" + std::to_string(station); }
  msg::OperatorRequest request(msg::OperatorRequest::Kind kind) {
    msg::OperatorRequest request;
    request.header = {fleet_robot_id(kOperator), 1, {}, ++asked_, {}};
    request.request = asked_;
    request.kind = kind;
    return request;
  }

  Served& served_;
  std::vector<PlaceId> stations_;
  Random random_;
  std::uint64_t asked_ = 0;
};

/// Plays the robots, one after the other, so that their reports are spread over time.
class LoadedFleet {
 public:
  LoadedFleet(Served& served, const std::vector<PlaceId>& at) : served_(served) {
    for (std::size_t i = 0; i < at.size(); ++i) {
      numbers_[fleet_robot_id(i)] = i;
      robots_.emplace_back(fleet_robot_id(i), at[i]);
      for (const msg::Message& message : robots_.back().arrive()) served_.handle(message);
    }
  }

  void run(double seconds, BusyOperator* busy) {
    const SteadyTime begin = served_.now().steady;
    const double between_s = kBetweenStates_s / static_cast<double>(robots_.size());
    double goals_s = 0.0;
    for (std::uint64_t turn = 1; between_s * static_cast<double>(turn) <= seconds; ++turn) {
      const double now_s = between_s * static_cast<double>(turn);
      served_.pass_until(begin + from_seconds(now_s));
      listen();
      if (busy != nullptr && now_s >= goals_s) {
        busy->keep_open(robots_.size());
        goals_s = now_s + kBetweenGoals_s;
      }
      ReportingPoint& robot = robots_[turn % robots_.size()];
      for (const msg::Message& message : robot.live(served_.now().steady)) served_.handle(message);
      ++turns;
      if (robot.drives()) ++driving;
    }
  }

  void forget() { turns = driving = orders = refused = 0; }
  std::uint64_t turns = 0;
  std::uint64_t driving = 0;
  std::uint64_t orders = 0;
  std::uint64_t refused = 0;

 private:
  void listen() {
    for (const msg::Message& message : served_.take()) {
      if (const auto* const order = std::get_if<msg::RouteOrder>(&message)) {
        ++orders;
        robots_[numbers_.at(order->to)].take(*order, served_.now().steady);
      } else if (const auto* const probe = std::get_if<msg::ClockProbe>(&message)) {
        robots_[numbers_.at(probe->to)].take(*probe, served_.now().wall);
      } else if (const auto* const reply = std::get_if<msg::OperatorReply>(&message)) {
        if (reply->outcome == msg::Outcome::refused || reply->outcome == msg::Outcome::failed) ++refused;
      }
    }
  }

  Served& served_;
  std::vector<ReportingPoint> robots_;
  std::map<RobotId, std::size_t> numbers_;
};

/// Draws so many cells, each once.
std::vector<PlaceId> draw_places(const TaughtLanes& lanes, std::size_t count, Random random) {
  std::vector<Cell> cells(lanes.cells());
  std::iota(cells.begin(), cells.end(), 0U);
  std::vector<PlaceId> places;
  for (std::size_t i = 0; i < count; ++i) {
    std::swap(cells[i], cells[i + random.below(cells.size() - i)]);
    places.push_back(lanes.place(cells[i]));
  }
  return places;
}

double longest_ms(const Timed& times) {
  double longest = 0.0;
  for (const std::vector<Took>& of_a_kind : times) {
    for (const Took& took : of_a_kind) longest = std::max(longest, took.processor_ms);
  }
  return longest;
}

}  // namespace

Loaded load_server(const TaughtLanes& lanes, const LoadPlan& plan) {
  Random random(plan.seed);
  Served served(lanes);
  served.pass_until(served.now().steady + from_seconds(kSettling_s));
  BusyOperator busy(served, draw_places(lanes, std::size_t{kStationsOfRobot} * plan.robots, random.fork(1)),
                    random.fork(2));
  LoadedFleet fleet(served, draw_places(lanes, plan.robots, random.fork(3)));
  fleet.run(kStanding_s, nullptr);
  BusyOperator* const sends = plan.has_goals ? &busy : nullptr;
  fleet.run(kWarmUp_s, sends);
  Loaded loaded;
  loaded.warm_up_longest_ms = longest_ms(served.take_times());
  fleet.forget();
  const std::uint64_t sent = busy.sent;
  const std::uint64_t commits = served.disk().commits;
  fleet.run(plan.seconds, sends);
  loaded.times = served.take_times();
  loaded.driving = static_cast<double>(fleet.driving) / static_cast<double>(fleet.turns);
  loaded.goals_per_hour = 3600.0 * static_cast<double>(busy.sent - sent) / plan.seconds;
  loaded.commits_per_s = static_cast<double>(served.disk().commits - commits) / plan.seconds;
  loaded.orders_per_s = static_cast<double>(fleet.orders) / plan.seconds;
  loaded.refused = fleet.refused;
  return loaded;
}

}  // namespace weft::bench
