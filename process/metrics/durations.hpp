#pragma once
#include "core/time.hpp"
#include "process/metrics/metric.hpp"

namespace weft::process {

/// Counts how long something took each time, from 0.1 ms to 10 s in steps of about three.
class Durations {
 public:
  Durations();
  /// Counts one duration; one below zero counts as none.
  void add(Duration duration);
  const DurationCounts& counts() const { return counts_; }

 private:
  DurationCounts counts_;
};

/// Makes a histogram of one series without labels.
Metric histogram(std::string name, std::string help, const Durations& durations);

}  // namespace weft::process
