#include "process/metrics/durations.hpp"

#include <algorithm>

namespace weft::process {

Durations::Durations() {
  counts_.bounds_s = {0.0001, 0.0003, 0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0};
  counts_.counts.resize(counts_.bounds_s.size() + 1);
}

void Durations::add(Duration duration) {
  const double took_s = std::max(seconds(duration), 0.0);
  const auto bound = std::ranges::lower_bound(counts_.bounds_s, took_s);
  ++counts_.counts[static_cast<std::size_t>(bound - counts_.bounds_s.begin())];
  counts_.sum_s += took_s;
}

Metric histogram(std::string name, std::string help, const Durations& durations) {
  return {std::move(name), std::move(help), MetricKind::histogram, {{{}, 0.0, durations.counts()}}};
}

}  // namespace weft::process
