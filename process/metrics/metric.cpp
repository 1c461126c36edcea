#include "process/metrics/metric.hpp"

#include <algorithm>
#include <set>
#include <string_view>

namespace weft::process {
namespace {

bool is_metric_name(std::string_view name) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || c == '_'; };
  const auto is_good = [&](char c) { return is_letter(c) || (c >= '0' && c <= '9'); };
  return !name.empty() && is_letter(name.front()) && std::ranges::all_of(name, is_good);
}

bool is_label_name(std::string_view name) {
  return is_metric_name(name) && !name.starts_with("__") && name != "le";
}

}  // namespace

std::string fault_of(const Metric& metric) {
  const std::string who = "metric \"" + metric.name + "\": ";
  if (!is_metric_name(metric.name)) return who + "its name must be of a-z, 0-9 and _";
  if (!metric.name.starts_with("weft_")) return who + "its name must begin with weft_";
  if (metric.help.empty()) return who + "it has no help";
  const bool is_total = metric.name.ends_with("_total");
  if ((metric.kind == MetricKind::counter) != is_total) return who + "counters, and no others, end in _total";
  std::set<MetricLabels> once;
  for (const MetricSeries& series : metric.series) {
    for (const auto& [label, value] : series.labels) {
      if (!is_label_name(label)) return who + "its label \"" + label + "\" must be of a-z, 0-9 and _";
    }
    MetricLabels sorted = series.labels;
    std::ranges::sort(sorted);
    if (!once.insert(sorted).second) return who + "two of its series have the same labels";
    if (metric.kind == MetricKind::histogram &&
        series.durations.counts.size() != series.durations.bounds_s.size() + 1)
      return who + "a histogram has one count more than bounds";
  }
  return {};
}

}  // namespace weft::process
