#include "agents/methods/command_lag.hpp"

#include <algorithm>
#include <cmath>

namespace weft::agents {
namespace {

constexpr double kDelaysS[] = {0.0, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4};
constexpr double kTimeConstantsS[] = {0.0, 0.05, 0.1, 0.2, 0.3, 0.5};
constexpr double kLongestS = 0.4;
constexpr double kLeverM = 0.3;  // by which a radian counts as metres
constexpr double kKept = 0.995;  // of what a step has told, from step to step
constexpr double kShortestS = 1e-4;

/// Brings what a base does nearer to a command for a while, and adds what it does meanwhile.
void near(double command, double time_constant_s, double for_s, double& rate, double& moved) {
  if (time_constant_s < kShortestS) {
    rate = command;
    moved += command * for_s;
    return;
  }
  const double left = std::exp(-for_s / time_constant_s);
  moved += command * for_s + (rate - command) * time_constant_s * (1.0 - left);
  rate = command + (rate - command) * left;
}

}  // namespace

CommandLag::CommandLag() {
  for (const double delay_s : kDelaysS)
    for (const double time_constant_s : kTimeConstantsS)
      candidates_.push_back({delay_s, time_constant_s, {}, {}, 0.0});
}

Twist CommandLag::next(const Motion& motion) {
  const double elapsed_s = std::max(0.0, seconds(motion.elapsed));
  commanded_.push_back({elapsed_s, motion.command});
  double kept_s = 0.0;
  for (const Commanded& one : commanded_) kept_s += one.for_s;
  while (commanded_.size() > 1 && kept_s - commanded_.front().for_s > kLongestS + elapsed_s) {
    kept_s -= commanded_.front().for_s;
    commanded_.pop_front();
  }
  for (Candidate& candidate : candidates_) go_on(candidate, elapsed_s);
  const Twist& moved = believed().moved;
  if (elapsed_s < kShortestS) return {};
  return {moved.linear_m_s / elapsed_s, moved.angular_rad_s / elapsed_s};
}

void CommandLag::go_on(Candidate& candidate, double elapsed_s) const {
  candidate.moved = {};
  double ends_s = 0.0;  // before now, where a command's time ends
  for (const Commanded& one : commanded_) ends_s += one.for_s;
  // The base does between `elapsed` ago and now what was commanded a delay earlier.
  const double from_s = candidate.delay_s + elapsed_s;
  const double to_s = candidate.delay_s;
  const double unknown_s = std::clamp(from_s - ends_s, 0.0, from_s - to_s);  // before the first command: it stood
  near(0.0, candidate.time_constant_s, unknown_s, candidate.rate.linear_m_s, candidate.moved.linear_m_s);
  near(0.0, candidate.time_constant_s, unknown_s, candidate.rate.angular_rad_s, candidate.moved.angular_rad_s);
  for (const Commanded& one : commanded_) {
    const double begins_s = ends_s;
    ends_s -= one.for_s;
    const double for_s = std::min(begins_s, from_s) - std::max(ends_s, to_s);
    if (for_s <= 0.0) continue;
    near(one.command.linear_m_s, candidate.time_constant_s, for_s, candidate.rate.linear_m_s,
         candidate.moved.linear_m_s);
    near(one.command.angular_rad_s, candidate.time_constant_s, for_s, candidate.rate.angular_rad_s,
         candidate.moved.angular_rad_s);
  }
}

void CommandLag::learn(const Pose2& seen) {
  for (Candidate& candidate : candidates_) {
    const double off_m = candidate.moved.linear_m_s - seen.x;
    const double off_rad = candidate.moved.angular_rad_s - seen.heading;
    candidate.badness = kKept * candidate.badness + off_m * off_m + kLeverM * kLeverM * off_rad * off_rad;
  }
}

const CommandLag::Candidate& CommandLag::believed() const {
  // The first of equals is the quickest base: nothing has told otherwise.
  return *std::min_element(candidates_.begin(), candidates_.end(),
                           [](const Candidate& a, const Candidate& b) { return a.badness < b.badness; });
}

double CommandLag::delay_s() const {
  return believed().delay_s;
}

double CommandLag::time_constant_s() const {
  return believed().time_constant_s;
}

}  // namespace weft::agents
