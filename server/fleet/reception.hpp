#pragma once
#include <chrono>
#include <cstdint>

#include "core/time.hpp"

namespace weft::server {

/// Counts what comes of one peer's messages, by the numbers that they bear. It begins some seconds after a new start
/// of the peer was heard: what late joiners are given first is old.
class Reception {
 public:
  static constexpr Duration kBegins = std::chrono::seconds(10);

  void hear(std::uint64_t incarnation, std::uint64_t sequence, SteadyTime now);
  /// Returns how many messages came of the peer's present start.
  std::uint64_t heard() const { return heard_; }
  /// Returns how many of those that it sent meanwhile did not come: lost, not sent, or overtaken by newer ones.
  std::uint64_t missed() const;

 private:
  std::uint64_t incarnation_ = 0;
  SteadyTime since_;
  std::uint64_t first_ = 0;
  std::uint64_t last_ = 0;
  std::uint64_t heard_ = 0;
};

}  // namespace weft::server
