#pragma once
#include "core/protocol/messages.hpp"
#include "core/time.hpp"
#include "server/base/context.hpp"

namespace weft::server {

/// Sends echoes back to the clients that measure the network, within a budget for all of them together, so that no
/// measurement takes the network from the fleet. What is beyond it is not answered, and counted.
class Echoes {
 public:
  static constexpr double kBytesPerSecond = 1e6;
  static constexpr double kBurstBytes = 250e3;
  /// Counts for each echo beside its load: headers of all layers, and the work that it makes.
  static constexpr double kBytesBeside = 1000.0;

  Echoes(Context& context, SteadyTime now) : context_(context), refilled_(now) {}

  void on_echo(const msg::Echo& echo, SteadyTime now);

 private:
  Context& context_;
  double budget_ = kBurstBytes;  ///< bytes that may be sent now
  SteadyTime refilled_;
};

}  // namespace weft::server
