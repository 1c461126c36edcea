#pragma once
#include <memory>
#include <optional>
#include <utility>

#include "core/result.hpp"
#include "server/base/counters.hpp"
#include "server/base/now.hpp"
#include "server/base/outbox.hpp"
#include "server/base/snapshots.hpp"
#include "storage/map_store.hpp"

namespace weft::server {

/// Commits to the store and to the served map, and is the only one that can: everybody else has both as const. Sends
/// every event of a transaction as a note once the transaction is durable, and knows whether the store takes anything
/// at the moment.
class MapWriter {
 public:
  using Served = std::shared_ptr<const Snapshot>;

  /// Begins with `stored`, the map as the store has it.
  MapWriter(storage::MapStore& store, Snapshot stored, Outbox& out, Counters& counters)
      : store_(store), out_(out), counters_(counters), snapshots_(std::move(stored)) {}

  /// Returns the map that is served from now on: of the revision that the transaction made, or the one before when it
  /// changes nothing of the map. The transaction is durable, told and served when it returns; the caller has checked
  /// that its changes fit the served map. After an error nothing of it is stored or told, every caller keeps its
  /// state as it was, and tries again when its cause comes again. Two errors end this server (`broken`): stale,
  /// another server has the store; and when it is stored and its map cannot be made, which `unserved` tells apart.
  Result<Served> commit(storage::Transaction transaction, Now now);
  /// Commits one event of its own. It is told even when the store cannot take it, and counted then.
  void note(msg::Event event, Now now);
  /// Tries whether a store that refused its last write takes one again, when it is time: nobody has to write for
  /// that. To be called when `next` has come, harmless earlier.
  void tick(Now now);
  /// Returns when the next trial is due; none: the store works, or this server has to end.
  std::optional<SteadyTime> next() const;

  /// Returns the served map, and those of the latest revisions.
  const Snapshots& snapshots() const { return snapshots_; }
  /// Returns why the store takes nothing at the moment, since its last commit; none when it works.
  const std::optional<Error>& stopped() const { return stopped_; }
  /// Returns why this server has to end: the store is another server's, or what is served is not what is stored any
  /// more.
  const std::optional<Error>& broken() const { return broken_; }
  /// Returns the revision that is stored and cannot be served; none: there is none.
  const std::optional<Revision>& unserved() const { return unserved_; }

 private:
  Result<void> serve(const storage::Transaction& transaction, Revision stored);
  void failed(const Error& error, Now now);
  void tell(const msg::Event& event, bool is_kept) {
    out_.send(msg::EventNote{.header = {}, .event = event, .is_kept = is_kept});
  }

  storage::MapStore& store_;
  Outbox& out_;
  Counters& counters_;
  Snapshots snapshots_;
  std::optional<Error> stopped_;
  SteadyTime try_at_{};  ///< while it is stopped
  std::optional<Error> broken_;
  std::optional<Revision> unserved_;
};

}  // namespace weft::server
