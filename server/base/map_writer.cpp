#include "server/base/map_writer.hpp"

#include <chrono>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "server/base/clipped.hpp"
#include "server/base/next_map.hpp"

namespace weft::server {
namespace {

constexpr Duration kBetweenTrials = std::chrono::seconds(5);
constexpr std::uint64_t kRoom = 1ULL << 20U;  ///< bytes free, without which a full disk counts as full

msg::Event works_again() {
  return {
      .at = {}, .kind = "store.works_again", .robot = {}, .goal = {}, .cause = "a write succeeded", .who = "server"};
}

}  // namespace

Result<MapWriter::Served> MapWriter::commit(storage::Transaction transaction, Now now) {
  if (broken_) return fail(*broken_);
  std::vector<msg::Event> events;
  for (auto& change : transaction.changes) {
    if (auto* const put = std::get_if<storage::PutEvent>(&change)) {
      put->event.at = now.wall;
      put->event.cause = clipped(std::move(put->event.cause));
      events.push_back(put->event);
    }
  }
  transaction.note.at = now.wall;
  const Result<storage::Commit> done = store_.commit(transaction);
  if (!done) {
    failed(done.error(), now);
    return fail(done.error());
  }
  for (const msg::Event& event : events) tell(event, true);
  if (std::exchange(stopped_, std::nullopt)) note(works_again(), now);
  if (const Result<void> served = serve(transaction, done->revision); !served) return fail(served.error());
  return snapshots_.shared_current();
}

/// Serves the map of the revision that the store has made. When that cannot be had, what is stored stays right and
/// what is served would not be it any more: the server has to end and load anew.
Result<void> MapWriter::serve(const storage::Transaction& transaction, Revision stored) {
  const Snapshot& map = snapshots_.current();
  if (stored == map.revision()) return {};
  std::optional<Snapshot> next;
  if (stored.value == map.revision().value + 1) next = next_map(map, transaction);
  if (!next) {
    Result<Snapshot> read = store_.snapshot_at(stored, map);
    if (!read) {
      unserved_ = stored;
      broken_ = {ErrorCode::internal,
                 "the edited map cannot be loaded, the server has to start anew: " + read.error().message};
      return fail(ErrorCode::internal, "it is stored as revision " + std::to_string(stored.value) +
                                           "; the server has to start anew (" + read.error().message + ")");
    }
    next = *std::move(read);
  }
  snapshots_.push(*std::move(next));
  return {};
}

void MapWriter::note(msg::Event event, Now now) {
  event.at = now.wall;
  event.cause = clipped(std::move(event.cause));
  const Result<storage::Commit> kept =
      broken_ ? Result<storage::Commit>(fail(*broken_)) : store_.commit({{storage::PutEvent{event}}});
  if (!kept) {
    ++counters_["store: event told but not kept"];
    failed(kept.error(), now);
  }
  tell(event, kept.has_value());
}

void MapWriter::tick(Now now) {
  if (next().value_or(SteadyTime::max()) > now.steady) return;
  try_at_ = now.steady + kBetweenTrials;
  // A log that has been emptied has room for a small write on a disk that has none.
  if (stopped_->code == ErrorCode::exhausted && store_.size().disk_free_bytes < kRoom) return;
  msg::Event event = works_again();
  event.at = now.wall;
  const Result<storage::Commit> done = store_.commit({{storage::PutEvent{event}}});
  if (!done) return failed(done.error(), now);
  stopped_.reset();
  tell(event, true);
}

std::optional<SteadyTime> MapWriter::next() const {
  return stopped_ && !broken_ ? std::optional(try_at_) : std::nullopt;
}

void MapWriter::failed(const Error& error, Now now) {
  ++counters_[std::string("store: ") + to_string(error.code)];
  // A conflict is about the transaction, not about the store.
  if (error.code == ErrorCode::conflict || error.code == ErrorCode::invalid) return;
  const bool is_new = !stopped_.has_value();
  stopped_ = error;
  if (is_new) try_at_ = now.steady + kBetweenTrials;
  if (error.code == ErrorCode::stale) broken_ = error;
  if (is_new) {
    tell({.at = now.wall, .kind = "store.stopped", .robot = {}, .goal = {}, .cause = error.message, .who = "server"},
         false);
  }
}

}  // namespace weft::server
