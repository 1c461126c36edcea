#pragma once
#include <memory>
#include <optional>

#include "core/random.hpp"
#include "core/time.hpp"
#include "idl/bus/bus.hpp"

namespace weft::bus {

/// Sets what a simulated network does to messages. Reliable topics suffer too: a link is not reliable across
/// restarts, and retries are the applications'.
struct Faults {
  double loss = 0.0;                   ///< [0, 1], of each message and reader
  double duplication = 0.0;            ///< [0, 1], once more with a delay of its own
  double reordering = 0.0;             ///< [0, 1], share of messages that others may overtake
  Duration delay_min{};                ///< >= 0
  Duration delay_max{};                ///< >= delay_min
  std::uint64_t bytes_per_second = 0;  ///< from each peer to each other; 0: no bound
};

/// Tells which messages of a peer a cut of its link loses.
enum class Cut : std::uint8_t {
  none,
  all,
  sent,     ///< what it says: it hears, and nobody hears it
  received  ///< what it is told: it is heard, and hears nobody
};

/// Simulates a network: the same topics and bytes as over DDS, delivered when the caller's time has come, in an order
/// that only the seed decides. For one thread. Buses hold on to the network that they belong to.
class InProcessNet {
 public:
  explicit InProcessNet(Random random);
  InProcessNet(InProcessNet&&) noexcept;
  InProcessNet& operator=(InProcessNet&&) noexcept;
  ~InProcessNet();

  /// Brings up a peer, which gets the last message of each key on `state` topics, as late joiners do. At most one bus
  /// a peer is alive; an older one of the same id is detached.
  std::unique_ptr<Bus> attach(msg::Role role, const PeerId& self);
  /// Takes a peer away at once, with what it sent and has not arrived, and what waits for it.
  void detach(const PeerId& peer);
  /// Cuts a peer's link, or heals it: loses all that `cut` tells, also what is under way. Once a direction is healed,
  /// its readers get `state` topics anew.
  void partition(const PeerId& peer, Cut cut);
  /// Closes a peer's link, or opens it anew, as happens over DDS to one whose address has changed: loses what is
  /// under way to or from it, keeps what waits to be taken. While it is closed, only `state` topics are published:
  /// they are told once it is open.
  void set_open(const PeerId& peer, bool is_open);
  void set_faults(const Faults& faults);

  void set_now(SteadyTime now);
  std::optional<SteadyTime> next_delivery() const;
  /// Moves everything that is due to its reader's inbox and sets the time. Never backwards.
  void deliver_until(SteadyTime now);

 private:
  class State;
  friend class InProcessBus;
  std::shared_ptr<State> state_;
};

}  // namespace weft::bus
