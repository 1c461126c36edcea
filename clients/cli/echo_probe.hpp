#pragma once
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "core/protocol/peers.hpp"
#include "core/time.hpp"

namespace weft::cli {

/// Says what came back of the echoes of one kind.
struct EchoCounts {
  std::size_t sent = 0;
  std::size_t returned = 0;
  std::size_t load_bytes = 0;    ///< of each
  std::vector<double> delays_s;  ///< there and back, of those that returned, ascending

  double loss() const;
  /// Returns the delay that this share of those that returned did not exceed; none returned: 0.
  double delay_s(double share) const;
};

/// Holds what was measured of the network between here and the server.
struct EchoReport {
  EchoCounts small;  ///< one packet each
  EchoCounts large;  ///< several packets each: all have to arrive
  EchoCounts flow;   ///< as large, as fast as the measurement is allowed to
  double flow_s = 0.0;

  /// Return bytes of load a second, each way.
  double offered_bytes_s() const;
  double returned_bytes_s() const;
};

/// Measures a network by echoes: small ones for delay and loss, larger ones for what becomes of several packets, then
/// a flow of these. Sends at most half a megabyte a second, which is what a server gives back to one client, and
/// nothing before the first echo has returned but a few small ones. Has no clock and sends nothing itself.
class EchoProbe {
 public:
  static constexpr Duration kLateAtMost = std::chrono::seconds(1);  ///< later ones count as lost

  EchoProbe(std::uint64_t request, SteadyTime now);

  /// Returns the next echo without its header, when it is time for one.
  std::optional<msg::Echo> due(SteadyTime now);
  /// Takes in what came. Echoes of others, and repeats, are left out.
  void hear(const msg::Echo& echo, SteadyTime now);
  /// Returns whether the server has answered at all.
  bool reaches() const { return reaches_; }
  bool done(SteadyTime now) const;
  /// Returns when something is due.
  SteadyTime next() const { return next_; }
  /// Returns for how long it measures once the server has answered.
  static Duration lasts();
  EchoReport report() const;

 private:
  struct Sent {
    std::size_t stage = 0;
    SteadyTime at;
    std::optional<double> delay_s;
  };

  std::uint64_t request_;
  std::size_t stage_ = 0;
  std::size_t sent_of_stage_ = 0;
  bool reaches_ = false;
  bool is_over_ = false;  ///< all is sent
  std::uint32_t number_ = 0;
  SteadyTime next_;
  SteadyTime flow_began_, flow_ended_;  ///< when its first and its last echo were sent
  std::map<std::uint32_t, Sent> sent_;
};

}  // namespace weft::cli
