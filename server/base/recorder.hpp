#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "core/result.hpp"
#include "server/base/now.hpp"
#include "server/base/outbox.hpp"
#include "storage/map_store.hpp"

namespace weft::server {

/// What people read is cut to what a message may carry.
std::string clipped(std::string text);

/// Refusals and the like, by name; shown in `map info`.
using Counters = std::map<std::string, std::uint64_t>;

/// The only way to the store's writing side. What is committed is told: every event of a transaction goes out as a
/// note once the transaction is durable. Knows whether the store takes anything at the moment.
class Recorder {
 public:
  Recorder(storage::MapStore& store, Outbox& out, Counters& counters)
      : store_(store), out_(out), counters_(counters) {}

  /// Durable and told when it returns. After an error nothing of it is stored and nobody was told; every caller
  /// keeps its state as it was and tries again when its cause comes again.
  Result<Revision> commit(storage::Transaction transaction, Now now);
  /// One event of its own. It is told even when the store cannot take it, and counted then.
  void note(msg::Event event, Now now);

  /// Why the store takes nothing at the moment, since its last commit; none when it works.
  const std::optional<Error>& stopped() const { return stopped_; }
  /// Another server has taken the store over: this one has to end.
  const std::optional<Error>& broken() const { return broken_; }
  /// What is served is not what is stored any more: this server has to end and load anew.
  void give_up(Error why) { broken_ = std::move(why); }

 private:
  void failed(const Error& error, Now now);
  void tell(const msg::Event& event) { out_.send(msg::EventNote{.header = {}, .event = event}); }

  storage::MapStore& store_;
  Outbox& out_;
  Counters& counters_;
  std::optional<Error> stopped_;
  std::optional<Error> broken_;
};

}  // namespace weft::server
