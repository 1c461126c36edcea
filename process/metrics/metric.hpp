#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace weft::process {

/// Holds what names one series of a metric: label and value, in the order in which they are shown.
using MetricLabels = std::vector<std::pair<std::string, std::string>>;

/// Counts durations by bounds. Counts are of each bound alone; the last one is of what is longer than every bound.
struct DurationCounts {
  std::vector<double> bounds_s;  ///< ascending
  std::vector<std::uint64_t> counts;
  double sum_s = 0.0;
};

/// Holds one series of a metric.
struct MetricSeries {
  MetricLabels labels;
  double value = 0.0;
  DurationCounts durations = {};  ///< of a histogram, in place of `value`
};

enum class MetricKind : std::uint8_t { counter, gauge, histogram };

/// Holds one metric with all its series, as Prometheus has them: names in base units, counters end in _total.
struct Metric {
  std::string name;
  std::string help;
  MetricKind kind = MetricKind::gauge;
  std::vector<MetricSeries> series;
};
using Metrics = std::vector<Metric>;

/// Make a metric of one series without labels.
inline Metric gauge(std::string name, std::string help, double value) {
  return {std::move(name), std::move(help), MetricKind::gauge, {{{}, value}}};
}
inline Metric counter(std::string name, std::string help, double value) {
  return {std::move(name), std::move(help), MetricKind::counter, {{{}, value}}};
}

/// Returns why a metric's names are none that Prometheus takes, its counter does not end in _total, it has no help,
/// or two of its series have the same labels; empty: it is sound.
std::string fault_of(const Metric& metric);

}  // namespace weft::process
