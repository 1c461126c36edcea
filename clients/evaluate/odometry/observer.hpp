#pragma once
#include <cstddef>
#include <functional>
#include <string>

#include "agents/bodies/body.hpp"
#include "agents/methods/method.hpp"
#include "clients/evaluate/floor/trace.hpp"

namespace weft::evaluate::odometry {

/// Watches a drive, or some of its images only, and says step by step how it went.
class Observer {
 public:
  using Observe = std::function<agents::Step(const agents::View*, const agents::Motion&)>;

  /// Makes an observer that is shown each `every`th sample; `cpu_s`: time that this thread has computed.
  Observer(std::string name, std::size_t every, Observe observe, std::function<double()> cpu_s)
      : name_(std::move(name)), every_(every), observe_(std::move(observe)), cpu_s_(std::move(cpu_s)) {}

  void take(const agents::Sample& sample);

  const std::string& name() const { return name_; }
  std::size_t every() const { return every_; }
  floor::Trace& trace() { return trace_; }
  const floor::Trace& trace() const { return trace_; }
  double ms_a_view() const { return views_ == 0 ? 0.0 : 1e3 * spent_s_ / static_cast<double>(views_); }

 private:
  std::string name_;
  std::size_t every_;
  Observe observe_;
  std::function<double()> cpu_s_;
  std::size_t samples_ = 0;
  std::size_t views_ = 0;
  double spent_s_ = 0.0;
  agents::Motion since_;  // the last sample shown
  bool has_wheels_ = true;
  Pose2 start_from_robot_;
  floor::Trace trace_;
};

}  // namespace weft::evaluate::odometry
