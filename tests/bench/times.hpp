#pragma once
#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <ctime>
#include <string>
#include <vector>

namespace weft::bench {

using Clock = std::chrono::steady_clock;

inline double milliseconds(Clock::duration time) {
  return std::chrono::duration<double, std::milli>(time).count();
}

/// Returns this thread's time. What others have to do on the same machine does not count in it.
inline double processor_ms() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_nsec) / 1e6;
}

/// Tells how long something took, by the clock on the wall and by the processor's.
struct Took {
  double wall_ms = 0.0;
  double processor_ms = 0.0;
  Took& operator+=(const Took& other) {
    wall_ms += other.wall_ms;
    processor_ms += other.processor_ms;
    return *this;
  }
};

template <class Act>
Took timed(Act&& act) {
  const auto begin = Clock::now();
  const double begin_ms = processor_ms();
  act();
  return {milliseconds(Clock::now() - begin), processor_ms() - begin_ms};
}

/// Collects times of single acts; reported as the median and what nine, or 99, of a hundred keep within.
class Times {
 public:
  template <class Act>
  void measure(Act&& act) {
    add(timed(act));
  }
  void add(const Took& took) {
    wall_.push_back(took.wall_ms);
    processor_.push_back(took.processor_ms);
  }
  /// Reports the times. `of`: what stands before the counters' names.
  void report(benchmark::State& state, const std::string& of = "") {
    if (wall_.empty()) return;
    report(state, of, wall_);
    const bool is_known = std::any_of(processor_.begin(), processor_.end(), [](double time) { return time > 0.0; });
    if (is_known) report(state, of + "cpu_", processor_);
  }

 private:
  static void report(benchmark::State& state, const std::string& of, std::vector<double>& times) {
    std::sort(times.begin(), times.end());
    state.counters[of + "median_ms"] = times[times.size() / 2];
    state.counters[of + "p90_ms"] = times[times.size() * 9 / 10];
    state.counters[of + "p99_ms"] = times[times.size() * 99 / 100];
    state.counters[of + "longest_ms"] = times.back();
  }

  std::vector<double> wall_;
  std::vector<double> processor_;
};

}  // namespace weft::bench
