#include <gtest/gtest.h>

#include <chrono>
#include <numeric>

#include "process/metrics/durations.hpp"
#include "process/metrics/metric.hpp"
#include "process/metrics/program_metrics.hpp"

namespace weft::process {
namespace {
using namespace std::chrono_literals;

TEST(Metric, SoundOnesHaveNoFault) {
  EXPECT_EQ(fault_of(gauge("weft_places", "Places", 3.0)), "");
  EXPECT_EQ(fault_of(counter("weft_sent_total", "Sent", 3.0)), "");
  EXPECT_EQ(fault_of(histogram("weft_handle_seconds", "Handled", Durations())), "");
}

TEST(Metric, FaultsAreNamed) {
  const auto is_about = [](const Metric& metric, const char* words) {
    EXPECT_NE(fault_of(metric).find(words), std::string::npos) << fault_of(metric);
  };
  is_about(gauge("weft-places", "Places", 0.0), "a-z, 0-9 and _");
  is_about(gauge("", "Places", 0.0), "a-z, 0-9 and _");
  is_about(gauge("places", "Places", 0.0), "weft_");
  is_about(gauge("weft_places", "", 0.0), "no help");
  is_about(gauge("weft_sent_total", "Sent", 0.0), "_total");
  is_about(counter("weft_sent", "Sent", 0.0), "_total");
  Metric labelled = gauge("weft_places", "Places", 0.0);
  labelled.series.front().labels = {{"le", "x"}};
  is_about(labelled, "its label \"le\"");
  Metric twice = gauge("weft_robots", "Robots", 0.0);
  twice.series = {{{{"robot", "r1"}, {"id", "1"}}, 0.0}, {{{"id", "1"}, {"robot", "r1"}}, 0.0}};
  is_about(twice, "same labels");
  Metric short_one = histogram("weft_handle_seconds", "Handled", Durations());
  short_one.series.front().durations.counts.pop_back();
  is_about(short_one, "one count more");
}

TEST(Durations, EachIsCountedBelowTheFirstBoundThatItDoesNotExceed) {
  Durations durations;
  durations.add(1ms);
  durations.add(1ms + 1ns);
  durations.add(1min);
  durations.add(-1s);
  const DurationCounts& counts = durations.counts();
  ASSERT_EQ(counts.counts.size(), counts.bounds_s.size() + 1);
  EXPECT_EQ(counts.counts.front(), 1U);
  EXPECT_EQ(counts.counts.back(), 1U);
  for (std::size_t i = 0; i < counts.bounds_s.size(); ++i) {
    if (counts.bounds_s[i] == 0.001 || counts.bounds_s[i] == 0.003) {
      EXPECT_EQ(counts.counts[i], 1U);
    }
  }
  EXPECT_EQ(std::accumulate(counts.counts.begin(), counts.counts.end(), std::uint64_t{0}), 4U);
  EXPECT_NEAR(counts.sum_s, 60.002, 1e-6);
}

TEST(ProgramMetrics, NameTheProgramAndWhetherItIsWell) {
  const Metrics metrics = program_metrics({.program = "weft-server",
                                           .version = "1.2.3",
                                           .vendor = "fastdds",
                                           .away_s = 0.0,
                                           .is_well = false,
                                           .handled = {},
                                           .ticked = {}});
  for (const Metric& metric : metrics) EXPECT_EQ(fault_of(metric), "");
  EXPECT_EQ(metrics[0].name, "weft_build_info");
  EXPECT_EQ(metrics[0].series.front().labels.at(1), (std::pair<std::string, std::string>("version", "1.2.3")));
  EXPECT_EQ(metrics[1].name, "weft_healthy");
  EXPECT_EQ(metrics[1].series.front().value, 0.0);
}

}  // namespace
}  // namespace weft::process
