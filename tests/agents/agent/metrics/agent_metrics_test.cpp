#include "agents/agent/metrics/agent_metrics.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace weft::agents {
namespace {

double value_of(const process::Metrics& metrics, const std::string& name, const process::MetricLabels& labels = {}) {
  const auto metric = std::ranges::find(metrics, name, &process::Metric::name);
  if (metric == metrics.end()) return -1.0;
  const auto series = std::ranges::find(metric->series, labels, &process::MetricSeries::labels);
  return series == metric->series.end() ? -2.0 : series->value;
}

TEST(AgentMetrics, AreSound) {
  for (const process::Metric& metric : agent_metrics({}, {})) EXPECT_EQ(process::fault_of(metric), "");
}

TEST(AgentMetrics, ShowWhatTheRobotDoesAndWhatTheLoopCounted) {
  AgentFigures figures;
  figures.state.mode = msg::RobotMode::teaching;
  figures.state.spool_batches = 3;
  figures.epoch = Epoch{7};
  figures.window_places = 40;
  figures.counters = {{"fixes", 12}};
  DriveFigures drive;
  drive.frames = 300;
  drive.lost_s = 1.5;
  drive.silent_server_s = 0.25;
  const process::Metrics metrics = agent_metrics(figures, drive);
  EXPECT_EQ(value_of(metrics, "weft_agent_mode", {{"state", "teaching"}}), 1.0);
  EXPECT_EQ(value_of(metrics, "weft_agent_mode", {{"state", "idle"}}), 0.0);
  EXPECT_EQ(value_of(metrics, "weft_agent_spool_batches"), 3.0);
  EXPECT_EQ(value_of(metrics, "weft_agent_epoch"), 7.0);
  EXPECT_EQ(value_of(metrics, "weft_agent_window_places"), 40.0);
  EXPECT_EQ(value_of(metrics, "weft_agent_frames_total"), 300.0);
  EXPECT_EQ(value_of(metrics, "weft_agent_lost_seconds_total"), 1.5);
  EXPECT_EQ(value_of(metrics, "weft_agent_server_silent_seconds"), 0.25);
  EXPECT_EQ(value_of(metrics, "weft_agent_counted_total", {{"what", "fixes"}}), 12.0);
}

TEST(AgentMetrics, ADiskOfWhichNothingIsKnownHasNoSeries) {
  AgentFigures figures;
  EXPECT_EQ(value_of(agent_metrics(figures, {}), "weft_agent_spool_free_bytes"), -2.0);
  EXPECT_EQ(value_of(agent_metrics(figures, {}), "weft_agent_spool_refusing"), 0.0);
  figures.state.spool_free_bytes = 70'000;
  figures.state.spool_refuses = "the disk is full";
  EXPECT_EQ(value_of(agent_metrics(figures, {}), "weft_agent_spool_free_bytes"), 70'000.0);
  EXPECT_EQ(value_of(agent_metrics(figures, {}), "weft_agent_spool_refusing"), 1.0);
}

}  // namespace
}  // namespace weft::agents
