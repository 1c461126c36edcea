#pragma once
#include "core/time.hpp"

namespace weft::agents {

/// Measures for how long nothing comes from the server: by that the server, which may hear this robot all the while,
/// learns that what it sends gets lost.
class ServerSilence {
 public:
  explicit ServerSilence(SteadyTime now) : heard_(now) {}

  /// Takes note that something of the server's has come.
  void hear(SteadyTime now);
  /// Leaves out a time in which this process could hear nothing.
  void was_away(Duration away, SteadyTime now);

  /// Returns for how long nothing has come; since the start when nothing ever did.
  Duration unheard(SteadyTime now) const { return now - heard_; }
  /// Returns the longest time without anything that lasts now or has ended within the last minute.
  Duration longest(SteadyTime now) const;

 private:
  SteadyTime heard_;
  Duration gap_{};  ///< the longest that has ended, as long as that is not long ago
  SteadyTime gap_ended_;
};

}  // namespace weft::agents
