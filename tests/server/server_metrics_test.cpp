#include "server/metrics/server_metrics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

#include "tests/server/arranged_site.hpp"

namespace weft::server::test {
namespace {

using process::Metric;
using process::MetricLabels;
using process::Metrics;
using process::MetricSeries;

/// Returns the series that has these among its labels; none: there is none, or there is no such metric.
std::optional<double> value_of(const Metrics& metrics, const std::string& name, const MetricLabels& labels = {}) {
  const auto metric = std::ranges::find(metrics, name, &Metric::name);
  if (metric == metrics.end()) return std::nullopt;
  for (const MetricSeries& series : metric->series) {
    const auto has = [&](const auto& label) {
      return std::ranges::find(series.labels, label) != series.labels.end();
    };
    if (std::ranges::all_of(labels, has)) return series.value;
  }
  return std::nullopt;
}

struct ServerMetricsTest : testing::Test {
  Metrics metrics() { return server_metrics(site.service().figures(site.now)); }
  std::optional<double> of_robot(const std::string& name, const std::string& robot) {
    return value_of(metrics(), name, {{"robot", robot}});
  }
  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  Peer r2{.id = robot_id(2), .name = "r1"};
};

TEST_F(ServerMetricsTest, AreSoundWithAndWithoutRobots) {
  for (const Metric& metric : metrics()) EXPECT_EQ(process::fault_of(metric), "");
  site.arrive(r1, std::nullopt);
  site.arrive(r2, std::nullopt);  // of the same name
  for (const Metric& metric : metrics()) EXPECT_EQ(process::fault_of(metric), "");
}

TEST_F(ServerMetricsTest, CountTheMapAndWhatIsAcknowledged) {
  TaughtRun run(r1, 10);
  site.arrive(r1, std::nullopt);
  site.hand_in(r1, run.next(3));
  const Metrics now = metrics();
  EXPECT_EQ(value_of(now, "weft_map_places"), 3.0);
  EXPECT_EQ(value_of(now, "weft_batches_acknowledged_total"), 1.0);
  EXPECT_EQ(value_of(now, "weft_store_refusing"), 0.0);
  EXPECT_EQ(value_of(now, "weft_server_epoch"), 1.0);
  EXPECT_GT(value_of(now, "weft_store_content_bytes").value(), 0.0);
}

TEST_F(ServerMetricsTest, ShowARobotAsItIs) {
  site.arrive(r1, std::nullopt);
  msg::RobotState state = site.state(r1, std::nullopt);
  state.mode = msg::RobotMode::lost;
  state.spool_batches = 4;
  state.spool_free_bytes = 1'000;
  state.spool_refuses = "the disk is full";
  site.say(state);
  site.power(r1, 0.25);
  EXPECT_EQ(of_robot("weft_robot_heard", "r1"), 1.0);
  EXPECT_EQ(of_robot("weft_robot_lost", "r1"), 1.0);
  EXPECT_EQ(of_robot("weft_robot_spool_batches", "r1"), 4.0);
  EXPECT_EQ(of_robot("weft_robot_spool_free_bytes", "r1"), 1'000.0);
  EXPECT_EQ(of_robot("weft_robot_spool_refusing", "r1"), 1.0);
  EXPECT_EQ(of_robot("weft_robot_charge_ratio", "r1"), 0.25);
  EXPECT_EQ(value_of(metrics(), "weft_robots", {{"state", "lost"}}), 1.0);
  site.pass(20s);
  EXPECT_EQ(of_robot("weft_robot_heard", "r1"), 0.0);
  EXPECT_EQ(of_robot("weft_robot_off", "r1"), 0.0);
  EXPECT_EQ(value_of(metrics(), "weft_robots", {{"state", "silent"}}), 1.0);
  EXPECT_EQ(value_of(metrics(), "weft_robots", {{"state", "lost"}}), 0.0);
}

TEST_F(ServerMetricsTest, WhatARobotDoesNotSayHasNoSeries) {
  site.arrive(r1, std::nullopt);
  site.say(site.state(r1, std::nullopt));
  EXPECT_EQ(of_robot("weft_robot_charge_ratio", "r1"), std::nullopt);
  EXPECT_EQ(of_robot("weft_robot_spool_free_bytes", "r1"), std::nullopt);
}

TEST_F(ServerMetricsTest, NobodyMissesARobotWhoseAgentWasEnded) {
  site.arrive(r1, std::nullopt);
  msg::RobotState last = site.state(r1, std::nullopt);
  last.mode = msg::RobotMode::off;
  site.say(last);
  site.pass(0s);
  EXPECT_EQ(of_robot("weft_robot_heard", "r1"), 0.0);
  EXPECT_EQ(of_robot("weft_robot_off", "r1"), 1.0);
}

TEST_F(ServerMetricsTest, ShowGoalsByStateAndTheOldestThatHasNotEnded) {
  TaughtRun run(r1, 10);
  site.arrive(r1, std::nullopt);
  site.hand_in(r1, run.next(3));
  site.label("dock", run.place(2));
  ASSERT_EQ(site.send_goal(1, "dock").outcome, msg::Outcome::accepted);
  site.pass(30s);
  const Metrics now = metrics();
  EXPECT_EQ(value_of(now, "weft_goals", {{"state", "pending"}}), 1.0);
  EXPECT_EQ(value_of(now, "weft_goals", {{"state", "succeeded"}}), 0.0);
  EXPECT_NEAR(value_of(now, "weft_goals_oldest_open_seconds").value(), 30.0, 0.1);
}

TEST_F(ServerMetricsTest, CountMessagesThatWereMissed) {
  site.arrive(r1, std::nullopt);
  for (int i = 0; i < 30; ++i) {
    site.pass(1s);
    if (i == 25) r1.sequence += 6;  // lost on the way
    site.say(site.state(r1, std::nullopt));
  }
  EXPECT_EQ(of_robot("weft_robot_messages_missed_total", "r1"), 6.0);
  EXPECT_GE(of_robot("weft_robot_messages_heard_total", "r1").value(), 20.0);
}

}  // namespace
}  // namespace weft::server::test
