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
#include "server/base/now.hpp"
#include "storage/map_store.hpp"

namespace weft::server {

/// Is the fleet map server without its edges: all its parts behind one state machine. It has no clock, thread or
/// socket; the store is its only effect besides the messages it returns. Messages go out in order.
class Service {
 public:
  virtual ~Service() = default;
  virtual std::vector<msg::Message> handle(const msg::Message& message, Now now) = 0;
  /// Retries, repeats, silence; to be called when `next_tick` has come, harmless earlier.
  virtual std::vector<msg::Message> tick(Now now) = 0;
  virtual std::optional<SteadyTime> next_tick() const = 0;
  /// The process was away for so long until now and could hear nobody. To be said before what has come in meanwhile
  /// is handled, and that before the next tick: nobody is blamed for silence in that time.
  virtual void was_away(Duration away, Now now) = 0;
  /// Refusals seen by the wire, to be shown in `map info`.
  virtual void count(const std::string& what, std::uint64_t times) = 0;

  /// What a message took on the wire: what each robot's window and contents cost is shown.
  virtual void sent(const msg::Message& message, std::size_t bytes) = 0;

  /// Another server has taken over the store: this one has nothing to say any more, and its process ends.
  virtual std::optional<Error> broken() const = 0;

  /// For invariants and records, never for deciding elsewhere.
  virtual const Snapshot& snapshot() const = 0;
  virtual std::vector<Goal> goals() const = 0;
};

/// Opens the store (which takes the next epoch) and resumes everything acknowledged, running goals included.
Result<std::unique_ptr<Service>> start(const ServiceConfig& config, storage::MapStore& store, Random random, Now now);

}  // namespace weft::server
