#include "agents/agent/missions/run_recorder.hpp"

namespace weft::agents {

void RunRecorder::begin() {
  uses_.navigator.begin_teach({.experience = run_.experience, .robot = uses_.robot, .others = run_.others});
  const std::vector<std::string> methods = uses_.navigator.teaches();
  begin(run_.experience, run_.name, methods.front());
  for (std::size_t i = 0; i < run_.others.size(); ++i) {
    begin(run_.others[i], name_of_other(run_.name, methods[i + 1]), methods[i + 1]);
  }
}

void RunRecorder::begin(ExperienceId experience, const std::string& name, const std::string& method) {
  uses_.spooler.begin(experience, name);
  uses_.refining.begin(experience, method);
}

Result<void> RunRecorder::keep(const std::vector<Kept>& kept, SteadyTime now) {
  for (const Kept& one : kept) {
    uses_.map.put(one.place.content.hash, one.content);
    if (Result<void> added = uses_.spooler.add(one, now); !added) return added;
    uses_.refining.add(one);
    run_.count(one);
  }
  return {};
}

/// Seals all experiences of the run; those that are refined are held back further.
Result<void> RunRecorder::close(const std::string& reason, SteadyTime now) {
  const Result<void> sealed = uses_.spooler.seal(reason, now);
  uses_.refining.end(run_.experience);
  for (const ExperienceId other : run_.others) uses_.refining.end(other);
  return sealed;
}

/// Hands in what the navigator has held back.
void RunRecorder::leave() {
  run_.told_apart = uses_.navigator.told_apart();
  const std::vector<Edge> held = uses_.navigator.leave_teach();
  for (const Edge& edge : held) uses_.spooler.add(edge);
  run_.count(held);
}

Result<void> RunRecorder::seal(SteadyTime now) {
  leave();
  const Result<void> sealed = close("taught to its end", now);
  if (!sealed) uses_.navigator.forget_taught(uses_.map.window());
  return sealed;
}

void RunRecorder::break_off(SteadyTime now) {
  bool is_spooled = true;
  for (const Kept& last : uses_.navigator.end_teach(uses_.map.view())) {
    const bool is_added = bool(uses_.spooler.add(last, now));
    if (is_added) uses_.refining.add(last);
    is_spooled = is_added && is_spooled;
  }
  leave();
  is_spooled = bool(close("teaching broke off", now)) && is_spooled;
  if (!is_spooled) uses_.navigator.forget_taught(uses_.map.window());
}

}  // namespace weft::agents
