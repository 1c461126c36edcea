#include "agents/agent/metrics/agent_metrics.hpp"

#include <utility>

namespace weft::agents {
namespace {

using process::counter;
using process::gauge;
using process::Metric;
using process::MetricKind;
using process::Metrics;

template <class Number>
double number_of(Number value) {
  return static_cast<double>(value);
}

Metric mode_of_agent(msg::RobotMode now) {
  Metric modes = {"weft_agent_mode", "1 for what the robot does, 0 for all else", MetricKind::gauge, {}};
  for (const msg::RobotMode mode :
       {msg::RobotMode::idle, msg::RobotMode::teaching, msg::RobotMode::driving, msg::RobotMode::waiting,
        msg::RobotMode::stopped, msg::RobotMode::lost, msg::RobotMode::faulted, msg::RobotMode::off}) {
    modes.series.push_back({{{"state", msg::to_string(mode)}}, mode == now ? 1.0 : 0.0});
  }
  return modes;
}

void add_drive(const AgentFigures& figures, const DriveFigures& drive, Metrics& all) {
  const msg::RobotState& state = figures.state;
  all.push_back(mode_of_agent(state.mode));
  all.push_back(counter("weft_agent_frames_total", "Samples of the body that were navigated by; the rate is in Hz",
                        number_of(drive.frames)));
  all.push_back(process::histogram("weft_agent_step_seconds", "How long samples took to navigate by", drive.stepped));
  all.push_back(counter("weft_agent_lost_seconds_total", "Time in which the robot was lost", drive.lost_s));
  all.push_back(gauge("weft_agent_localised", "1 while the robot knows where it is", state.localised ? 1.0 : 0.0));
  all.push_back(gauge("weft_agent_blind_meters", "How far the robot has driven since its last fix", state.blind_m));
  all.push_back(gauge("weft_agent_speed_meters_per_second", "The robot's speed", state.speed_m_s));
  all.push_back(gauge("weft_agent_body_failed", "1 after the body failed: the robot stands",
                      drive.has_body_failed ? 1.0 : 0.0));
}

void add_window(const AgentFigures& figures, Metrics& all) {
  const msg::RobotState& state = figures.state;
  all.push_back(
      gauge("weft_agent_epoch", "Epoch of the agent's server; 0: none was heard", number_of(figures.epoch.value)));
  all.push_back(gauge("weft_agent_window_places", "Places of the window", number_of(figures.window_places)));
  all.push_back(
      gauge("weft_agent_window_revision", "Revision of the window", number_of(state.window_revision.value)));
  all.push_back(gauge("weft_agent_contents_missing", "Contents of the window that have not come yet",
                      number_of(state.contents_missing)));
  all.push_back(gauge("weft_agent_memory_bytes", "Contents held in memory", number_of(state.memory_bytes)));
  all.push_back(
      gauge("weft_agent_memory_limit_bytes", "What they may take at most", number_of(state.memory_cap_bytes)));
}

void add_spool(const AgentFigures& figures, Metrics& all) {
  const msg::RobotState& state = figures.state;
  all.push_back(gauge("weft_agent_spool_batches", "Batches in the spool that the server has not acknowledged",
                      number_of(state.spool_batches)));
  Metric room = {"weft_agent_spool_free_bytes", "Free bytes of the spool's disk", MetricKind::gauge, {}};
  if (state.spool_free_bytes) room.series.push_back({{}, number_of(*state.spool_free_bytes)});
  all.push_back(std::move(room));
  all.push_back(gauge("weft_agent_spool_refusing", "1 while the spool's disk refuses: its last write failed",
                      state.spool_refuses.empty() ? 0.0 : 1.0));
}

}  // namespace

Metrics agent_metrics(const AgentFigures& figures, const DriveFigures& drive) {
  Metrics all;
  add_drive(figures, drive, all);
  add_window(figures, all);
  add_spool(figures, all);
  all.push_back(gauge("weft_agent_server_silent_seconds",
                      "Time since the server was heard last, or since the agent's start", drive.silent_server_s));
  Metric counted = {
      "weft_agent_counted_total", "Fixes, and what was refused or ignored, by name", MetricKind::counter, {}};
  for (const auto& [what, times] : figures.counters) counted.series.push_back({{{"what", what}}, number_of(times)});
  all.push_back(std::move(counted));
  return all;
}

}  // namespace weft::agents
