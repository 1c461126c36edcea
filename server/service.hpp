#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/protocol/messages.hpp"
#include "core/random.hpp"
#include "core/result.hpp"
#include "core/time.hpp"
#include "server/base/config.hpp"
#include "server/base/figures.hpp"
#include "server/base/now.hpp"
#include "storage/map_store.hpp"

namespace weft::server {

/// Is the fleet map server without its edges: all its parts behind one state machine. It has no clock, thread or
/// socket; the store is its only effect besides the messages it returns. Messages go out in order.
class Service {
 public:
  virtual ~Service() = default;
  virtual std::vector<msg::Message> handle(const msg::Message& message, Now now) = 0;
  /// Does what is due: retries, repeats, silence. To be called when `next_tick` has come, harmless earlier.
  virtual std::vector<msg::Message> tick(Now now) = 0;
  virtual std::optional<SteadyTime> next_tick() const = 0;
  /// Notes that the process was away for so long until now and could hear nobody. To be called before what has come
  /// in meanwhile is handled, and that before the next tick: nobody is blamed for silence in that time.
  virtual void was_away(Duration away, Now now) = 0;
  /// Counts refusals seen by the wire, to be shown in `map info`.
  virtual void count(const std::string& what, std::uint64_t times) = 0;

  /// Notes what a message took on the wire: what each robot's window and contents cost is shown.
  virtual void sent(const msg::Message& message, std::size_t bytes) = 0;

  /// Returns why the process has to end: another server has taken over the store, or the map that is served is not
  /// the stored one.
  virtual std::optional<Error> broken() const = 0;

  /// Returns why the store has refused the last write; none: it took it.
  virtual std::optional<Error> store_refuses() const = 0;

  /// Returns the goal that the robot is to reach; none: it has none. For the log.
  virtual GoalId goal_of(const RobotId& robot) const = 0;
  /// Returns how the server and its fleet are, in numbers, for whoever watches them.
  virtual Figures figures(Now now) const = 0;

  /// Returns the served map, for invariants and records, never for deciding elsewhere.
  virtual const Snapshot& snapshot() const = 0;
  virtual std::vector<Goal> goals() const = 0;
};

/// Opens the store (which takes the next epoch) and resumes everything acknowledged, running goals included.
Result<std::unique_ptr<Service>> start(const ServiceConfig& config, storage::MapStore& store, Random random, Now now);

}  // namespace weft::server
