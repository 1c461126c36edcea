#pragma once
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <vector>

namespace weft::bench {

using Clock = std::chrono::steady_clock;

inline double milliseconds(Clock::duration time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

/// Times of single acts; reported as the median and what nine, or 99, of a hundred keep within.
class Times {
 public:
  template <class Act>
  void measure(Act&& act) {
    const auto begin = Clock::now();
    act();
    add(milliseconds(Clock::now() - begin));
  }
  void add(double time_ms) { times_.push_back(time_ms); }
  /// `of`: what stands before the counters' names.
  void report(benchmark::State& state, const std::string& of = "") {
    if (times_.empty()) return;
    std::sort(times_.begin(), times_.end());
    state.counters[of + "median_ms"] = times_[times_.size() / 2];
    state.counters[of + "p90_ms"] = times_[times_.size() * 9 / 10];
    state.counters[of + "p99_ms"] = times_[times_.size() * 99 / 100];
    state.counters[of + "longest_ms"] = times_.back();
  }

 private:
  std::vector<double> times_;
};

}  // namespace weft::bench
