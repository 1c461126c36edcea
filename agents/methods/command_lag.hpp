#pragma once
#include <cstddef>
#include <deque>
#include <vector>

#include "agents/perception/motion.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::agents {

/// Learns how late a base obeys, from steps that vision has seen: a command takes effect after a delay, and what the
/// base does nears it with a time constant. A robot that sees nothing and takes its commands for what it does is off
/// by its speed times both, each time that it starts, stops or turns. Several of each are followed side by side, and
/// the pair that has told the seen steps best is believed. A value: to be fed each sample in turn.
class CommandLag {
 public:
  CommandLag();

  /// Takes the next sample's command, and returns the twist that the base made of its commands, in the mean of
  /// `motion.elapsed`. Wheels are not looked at.
  Twist next(const Motion& motion);
  /// Tells what was truly done during the sample that `next` was told of last.
  void learn(const Pose2& seen);

  double delay_s() const;
  double time_constant_s() const;

 private:
  struct Commanded {
    double for_s = 0.0;
    Twist command;
  };
  /// Holds one pair, and what a base of that kind would be doing now.
  struct Candidate {
    double delay_s = 0.0;
    double time_constant_s = 0.0;
    Twist rate;
    Twist moved;           // during the last sample: metres and radians
    double badness = 0.0;  // squared errors of steps, older ones less
  };

  void go_on(Candidate& candidate, double elapsed_s) const;
  const Candidate& believed() const;

  std::deque<Commanded> commanded_;  // the newest last; as long as the longest delay and a sample
  std::vector<Candidate> candidates_;
};

}  // namespace weft::agents
