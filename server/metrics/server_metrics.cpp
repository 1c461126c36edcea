#include "server/metrics/server_metrics.hpp"

#include <array>
#include <string>
#include <utility>

namespace weft::server {
namespace {

using process::counter;
using process::gauge;
using process::Metric;
using process::MetricKind;
using process::Metrics;

double number(std::uint64_t value) {
  return static_cast<double>(value);
}

double flag(bool value) {
  return value ? 1.0 : 0.0;
}

void add_map(const Figures& figures, Metrics& all) {
  all.push_back(
      gauge("weft_server_epoch", "The server's epoch: one more at each start", number(figures.epoch.value)));
  all.push_back(gauge("weft_map_revision", "The map's revision", number(figures.revision.value)));
  all.push_back(gauge("weft_map_experiences", "Experiences of the map", number(figures.experiences)));
  all.push_back(gauge("weft_map_places", "Places of the map", number(figures.places)));
  all.push_back(gauge("weft_map_stitches", "Stitches of the map", number(figures.stitches)));
  all.push_back(gauge("weft_store_contents", "Contents in the store", number(figures.contents)));
  all.push_back(gauge("weft_store_content_bytes", "Their bytes as stored", number(figures.content_bytes)));
  all.push_back(
      gauge("weft_store_disk_free_bytes", "Free bytes of the store's disk", number(figures.disk_free_bytes)));
  all.push_back(
      gauge("weft_store_refusing", "1 while the store refuses: its last write failed", flag(figures.store_refuses)));
}

void add_work(const Figures& figures, Metrics& all) {
  all.push_back(counter("weft_batches_acknowledged_total", "Batches that are on the server's disk, since its start",
                        number(figures.batches_acknowledged)));
  all.push_back(counter("weft_batches_refused_total", "Batches that were refused for good, since the server's start",
                        number(figures.batches_refused)));
  all.push_back(gauge("weft_intake_bytes", "Bytes reserved for contents on their way to the server",
                      number(figures.intake_bytes)));
  all.push_back(gauge("weft_windows", "Windows that are kept as the map has them", number(figures.windows)));
  all.push_back(
      gauge("weft_windows_behind", "Those that may not be as the map has them", number(figures.windows_behind)));
  all.push_back(gauge("weft_contents_to_send", "Contents that robots asked for and that are not sent yet",
                      number(figures.contents_to_send)));
  all.push_back(gauge("weft_recognitions_waiting", "Recognition queries that wait for their answer",
                      number(figures.recognitions_waiting)));
  Metric counted = {"weft_server_counted_total",
                    "What the server refused or ignored, and the like, as weft map info counts it",
                    MetricKind::counter,
                    {}};
  for (const auto& [what, times] : figures.counters) counted.series.push_back({{{"what", what}}, number(times)});
  all.push_back(std::move(counted));
}

void add_goals(const Figures& figures, Metrics& all) {
  Metric goals = {"weft_goals", "Goals by state, ended ones too", MetricKind::gauge, {}};
  for (const GoalState state : {GoalState::pending, GoalState::assigned, GoalState::executing, GoalState::paused,
                                GoalState::succeeded, GoalState::failed, GoalState::cancelled, GoalState::rejected}) {
    const auto found = figures.goals.find(state);
    goals.series.push_back(
        {{{"state", to_string(state)}}, found == figures.goals.end() ? 0.0 : number(found->second)});
  }
  all.push_back(std::move(goals));
  all.push_back(gauge("weft_goals_oldest_open_seconds", "Age of the oldest goal that has not ended; 0: there is none",
                      figures.oldest_goal_s));
  all.push_back(gauge("weft_standstills", "Standstills that have lasted", number(figures.standstills)));
}

/// Counts robots by what they do; those that are not heard are silent.
void add_modes(const Figures& figures, Metrics& all) {
  std::map<std::string, double> modes = {{"silent", 0.0}};
  for (const msg::RobotMode mode :
       {msg::RobotMode::idle, msg::RobotMode::teaching, msg::RobotMode::driving, msg::RobotMode::waiting,
        msg::RobotMode::stopped, msg::RobotMode::lost, msg::RobotMode::faulted, msg::RobotMode::off}) {
    modes[msg::to_string(mode)] = 0.0;
  }
  for (const RobotFigures& robot : figures.robots) ++modes[robot.is_heard ? msg::to_string(robot.mode) : "silent"];
  Metric robots = {"weft_robots", "Robots by what they do; silent: not heard", MetricKind::gauge, {}};
  for (const auto& [mode, count] : modes) robots.series.push_back({{{"state", mode}}, count});
  all.push_back(std::move(robots));
}

/// Describes a metric of each robot. none: the robot has no such series now.
struct OfRobot {
  const char* name;
  const char* help;
  MetricKind kind;
  std::optional<double> (*value)(const RobotFigures& robot);
};
using Value = std::optional<double>;
constexpr std::array kOfRobot = {
    OfRobot{"weft_robot_heard", "1 while the robot is heard, 0 while it counts as silent", MetricKind::gauge,
            [](const RobotFigures& robot) -> Value { return flag(robot.is_heard); }},
    OfRobot{"weft_robot_off", "1 after the robot's agent was ended in good order, until it is heard again",
            MetricKind::gauge, [](const RobotFigures& robot) -> Value { return flag(robot.was_ended); }},
    OfRobot{"weft_robot_silent_seconds", "Time since the robot was heard last", MetricKind::gauge,
            [](const RobotFigures& robot) -> Value { return robot.silent_s; }},
    OfRobot{"weft_robot_lost", "1 while the robot is lost", MetricKind::gauge,
            [](const RobotFigures& robot) -> Value { return flag(robot.mode == msg::RobotMode::lost); }},
    OfRobot{"weft_robot_faulted", "1 while the robot has a fault", MetricKind::gauge,
            [](const RobotFigures& robot) -> Value { return flag(robot.mode == msg::RobotMode::faulted); }},
    OfRobot{"weft_robot_localised", "1 while the robot knows where it is", MetricKind::gauge,
            [](const RobotFigures& robot) -> Value { return flag(robot.is_localised); }},
    OfRobot{"weft_robot_waiting", "1 while the robot stands and waits for others, or for a rule", MetricKind::gauge,
            [](const RobotFigures& robot) -> Value { return flag(robot.waits); }},
    OfRobot{"weft_robot_in_standstill", "1 while the robot is in a standstill, or waits behind one",
            MetricKind::gauge, [](const RobotFigures& robot) -> Value { return flag(robot.is_in_standstill); }},
    OfRobot{"weft_robot_twins", "1 while two live agents share the robot's id", MetricKind::gauge,
            [](const RobotFigures& robot) -> Value { return flag(robot.are_twins); }},
    OfRobot{"weft_robot_deaf", "1 while the robot is heard and has heard nothing of the server for 3.5 s",
            MetricKind::gauge, [](const RobotFigures& robot) -> Value { return flag(robot.is_deaf); }},
    OfRobot{"weft_robot_clock_skew_seconds", "How far the robot's clock is ahead of the server's", MetricKind::gauge,
            [](const RobotFigures& robot) -> Value { return robot.clock_skew_s; }},
    OfRobot{"weft_robot_blind_meters", "How far the robot has driven since its last fix", MetricKind::gauge,
            [](const RobotFigures& robot) -> Value { return robot.blind_m; }},
    OfRobot{"weft_robot_charge_ratio", "What the robot's battery holds, as a share of full", MetricKind::gauge,
            [](const RobotFigures& robot) { return robot.charge; }},
    OfRobot{"weft_robot_contents_missing", "Contents of the robot's window that it has not got yet",
            MetricKind::gauge, [](const RobotFigures& robot) -> Value { return number(robot.contents_missing); }},
    OfRobot{"weft_robot_memory_bytes", "Contents that the robot holds in memory", MetricKind::gauge,
            [](const RobotFigures& robot) -> Value { return number(robot.memory_bytes); }},
    OfRobot{"weft_robot_spool_batches", "Batches in the robot's spool that are not acknowledged", MetricKind::gauge,
            [](const RobotFigures& robot) -> Value { return number(robot.spool_batches); }},
    OfRobot{"weft_robot_spool_free_bytes", "Free bytes of the disk of the robot's spool", MetricKind::gauge,
            [](const RobotFigures& robot) -> Value {
              return robot.spool_free_bytes ? Value(number(*robot.spool_free_bytes)) : std::nullopt;
            }},
    OfRobot{"weft_robot_spool_refusing", "1 while the robot's disk refuses: its last write failed", MetricKind::gauge,
            [](const RobotFigures& robot) -> Value { return flag(robot.spool_refuses); }},
    OfRobot{"weft_robot_window_sent_bytes_total", "Bytes of windows sent to the robot", MetricKind::counter,
            [](const RobotFigures& robot) -> Value { return number(robot.window_bytes); }},
    OfRobot{"weft_robot_content_sent_bytes_total", "Bytes of contents sent to the robot", MetricKind::counter,
            [](const RobotFigures& robot) -> Value { return number(robot.content_bytes); }},
    OfRobot{"weft_robot_messages_heard_total", "Messages of the robot that came, since its agent's start",
            MetricKind::counter, [](const RobotFigures& robot) -> Value { return number(robot.messages_heard); }},
    OfRobot{"weft_robot_messages_missed_total", "Those that it sent meanwhile and that did not come",
            MetricKind::counter, [](const RobotFigures& robot) -> Value { return number(robot.messages_missed); }},
};

void add_robots(const Figures& figures, Metrics& all) {
  for (const OfRobot& one : kOfRobot) {
    Metric metric = {one.name, one.help, one.kind, {}};
    for (const RobotFigures& robot : figures.robots) {
      const std::optional<double> value = one.value(robot);
      if (value) metric.series.push_back({{{"robot", robot.name}, {"id", to_string(robot.id)}}, *value});
    }
    all.push_back(std::move(metric));
  }
}

}  // namespace

Metrics server_metrics(const Figures& figures) {
  Metrics all;
  add_map(figures, all);
  add_work(figures, all);
  add_goals(figures, all);
  add_modes(figures, all);
  add_robots(figures, all);
  return all;
}

}  // namespace weft::server
