#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/network/window.hpp"
#include "core/random.hpp"
#include "server/service.hpp"
#include "tests/bench/times.hpp"

namespace weft::bench {

/// Simulates a fleet at work on a large site, one message after the other as they would come in: robots teach, each
/// batch with its contents, and agents drive along and ask for the window around them. The clock that the server sees
/// goes on by what its answers truly take, and jumps when it has nothing to do.
class Load {
 public:
  struct Rates {
    double batches = 20.0;  ///< of 20 places, a second
    std::uint32_t agents = 20;
    double windows = 1.0;  ///< asked by each agent, a second
  };
  /// Makes a load. `clock_s`: the server's clock, at which the last load ended.
  Load(server::Service& service, double& clock_s, const Rates& rates);

  void run(double seconds);

  /// Measures from when a window is asked for, or may be told again (half a second after the last), until it is said.
  Times waits;
  Times windows;  ///< that were answered at once: what that took
  Times batches;
  Times ticks;
  std::uint64_t places_sent = 0;  ///< in windows and patches
  std::uint64_t batches_joined = 0;

 private:
  struct Agent {
    PeerId id;
    PlaceId at;
    std::uint64_t definition = 0;
    std::uint64_t sequence = 0;
    double next_s = 0.0;
    double asked_s = 0.0;
    bool is_waiting = false;
    double told_s = 0.0;
    Window held;
    Digest held_digest;
  };
  struct Teacher {
    RobotId id;
    ExperienceId experience;
    PlaceId follows;  ///< drives behind an earlier run
    std::uint64_t sequence = 0;
    std::uint64_t batch = 0;
    std::uint32_t places = 0;
  };

  void arrive(const PeerId& id);
  void ask(Agent& agent);
  void teach();
  Batch next_batch(Teacher& teacher, std::vector<Bytes>& contents);
  Took handle(const msg::Message& message);
  void tick_if_due();
  /// Takes the server's messages. `took`: the time to answer one message; none: it was a tick, for several perhaps.
  void take(const std::vector<msg::Message>& messages, const std::optional<Took>& took);
  server::Now now() const;

  server::Service& service_;
  double& now_s_;
  Rates rates_;
  Random random_;
  std::vector<Agent> agents_;
  std::vector<Teacher> teachers_;
  std::size_t next_teacher_ = 0;
};

}  // namespace weft::bench
