#include "agents/agent/missions/run_recorder.hpp"

namespace weft::agents {

void RunRecorder::begin() {
  uses_.navigator.begin_teach({.experience = run_.experience, .robot = uses_.robot, .others = run_.others});
  uses_.spooler.begin(run_.experience, run_.name);
  const std::vector<std::string> methods = uses_.navigator.teaches();
  for (std::size_t i = 0; i < run_.others.size(); ++i) {
    uses_.spooler.begin(run_.others[i], name_of_other(run_.name, methods[i + 1]));
  }
}

Result<void> RunRecorder::keep(const std::vector<Kept>& kept, SteadyTime now) {
  for (const Kept& one : kept) {
    uses_.map.put(one.place.content.hash, one.content);
    if (Result<void> added = uses_.spooler.add(one, now); !added) return added;
    run_.count(one);
  }
  return {};
}

Result<void> RunRecorder::seal(SteadyTime now) {
  uses_.navigator.leave_teach();
  const Result<void> sealed = uses_.spooler.seal("taught to its end", now);
  if (!sealed) uses_.navigator.forget_taught(uses_.map.window());
  return sealed;
}

void RunRecorder::break_off(SteadyTime now) {
  bool is_spooled = true;
  for (const Kept& last : uses_.navigator.end_teach(uses_.map.view())) {
    is_spooled = bool(uses_.spooler.add(last, now)) && is_spooled;
  }
  uses_.navigator.leave_teach();
  is_spooled = bool(uses_.spooler.seal("teaching broke off", now)) && is_spooled;
  if (!is_spooled) uses_.navigator.forget_taught(uses_.map.window());
}

}  // namespace weft::agents
