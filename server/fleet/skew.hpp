#pragma once
#include <array>
#include <cstdint>
#include <optional>

#include "core/protocol/messages.hpp"
#include "server/base/now.hpp"

namespace weft::server {

/// Measures how far a peer's wall clock is ahead of ours: offset of RFC 5905 section 8, taken from the probe with the
/// shortest round trip among the last eight. For people; no decision uses it.
class ClockSkew {
 public:
  /// Notes that a probe goes out now.
  void sent(std::uint64_t probe, SteadyTime now);
  /// Takes a reply; late and unknown ones are ignored.
  void answered(const msg::ClockReply& reply, Now now);
  /// Returns seconds, positive when the peer's clock is ahead.
  std::optional<double> seconds_ahead() const;

 private:
  struct Pending {
    std::uint64_t probe = 0;
    SteadyTime sent{};
  };
  struct Sample {
    Duration round_trip{};
    Duration ahead{};
  };
  std::array<Pending, 4> pending_{};
  std::size_t next_pending_ = 0;
  std::array<Sample, 8> samples_{};
  std::size_t sample_count_ = 0;  ///< ever; the array is a ring
};

}  // namespace weft::server
