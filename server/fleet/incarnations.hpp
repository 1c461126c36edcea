#pragma once
#include <cstdint>
#include <vector>

#include "core/time.hpp"

namespace weft::server {

/// Tells a restarted process from two live ones of the same id. The newest incarnation is the current one. An older
/// one that still speaks well after it was replaced, and speaks again, is alive: both are twins.
class Incarnations {
 public:
  enum class Verdict : std::uint8_t {
    current,  ///< go on
    first,    ///< nobody was heard before since the server started
    fresh,    ///< a new one has taken over just now: the robot's agent was restarted
    late,     ///< from a replaced one, still on the way: to be ignored
    twin,     ///< two are alive: nobody can be trusted to be the robot
  };

  Verdict hear(std::uint64_t incarnation, SteadyTime now);
  bool twins() const { return twins_; }
  /// Ends the twins' state once only one of them was heard within `quiet`. Returns true if it ended now.
  bool settle(SteadyTime now, Duration quiet);
  /// Leaves a time in which nobody could be heard out of everybody's silence.
  void excuse(Duration away, SteadyTime now);
  std::uint64_t current() const { return current_; }

 private:
  struct Known {
    std::uint64_t incarnation = 0;
    SteadyTime heard;
    int strikes = 0;  ///< how often it spoke when it should long have been gone
  };
  Known* find(std::uint64_t incarnation);

  std::vector<Known> known_;  // the last few, oldest first
  std::uint64_t current_ = 0;
  SteadyTime since_;  // when the current one took over
  bool twins_ = false;
};

}  // namespace weft::server
