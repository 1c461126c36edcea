#pragma once
#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "server/service.hpp"
#include "storage/memory/memory_store.hpp"
#include "tests/bench/times.hpp"
#include "tests/bench/traffic/taught_lanes.hpp"

namespace weft::bench {

/// Names what a server does while it is timed: what it handles, by kind, and its ticks.
enum class Work : std::uint8_t { state, progress, request, other, tick };
inline constexpr std::size_t kWorks = 5;
const char* to_string(Work work);

/// Holds how long each act took, by what it was.
using Timed = std::array<std::vector<Took>, kWorks>;

/// Runs a whole server over taught lanes on a store in memory, in simulated time, and times each thing that it does.
class Served {
 public:
  /// Stores the lanes and starts a server on them. Throws when it does not start.
  explicit Served(const TaughtLanes& lanes);

  void handle(const msg::Message& message);
  /// Moves the clock to `end`, with every tick in its place.
  void pass_until(SteadyTime end);
  server::Now now() const { return now_; }

  /// Returns what was said since the last call.
  std::vector<msg::Message> take() { return std::exchange(said_, {}); }
  /// Returns the times since the last call.
  Timed take_times() { return std::exchange(times_, {}); }
  const storage::MemoryDisk& disk() const { return *disk_; }

 private:
  std::shared_ptr<storage::MemoryDisk> disk_;
  std::unique_ptr<storage::MapStore> store_;
  std::unique_ptr<server::Service> service_;
  server::Now now_{.steady = SteadyTime(std::chrono::seconds(1000)), .wall = WallTime(std::chrono::seconds(5000))};
  std::vector<msg::Message> said_;
  Timed times_;
};

}  // namespace weft::bench
