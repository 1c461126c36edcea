#include "server/queries/past_maps.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace weft::server {
namespace {
using namespace std::chrono_literals;

constexpr Duration kHeld = 30s;
/// Allows two to compare, and one for somebody who draws or exports meanwhile. Each may be as large as the map.
constexpr std::size_t kMost = 3;

}  // namespace

Result<std::shared_ptr<const Snapshot>> PastMaps::found(Revision revision) const {
  const Snapshot& current = context_.snapshots.current();
  if (revision > current.revision()) {
    return fail(ErrorCode::refused, "the map has no revision " + std::to_string(revision.value) + "; its newest is " +
                                        std::to_string(current.revision().value) + ": see `weft map log`");
  }
  if (std::shared_ptr<const Snapshot> kept = context_.snapshots.at(revision)) return kept;
  Result<Snapshot> stored = context_.store.snapshot_at(revision, current);
  if (!stored) return fail(stored.error());
  return std::make_shared<const Snapshot>(*std::move(stored));
}

Result<std::shared_ptr<const Snapshot>> PastMaps::at(Revision revision, SteadyTime now) {
  if (revision == Revision{}) revision = context_.snapshots.current().revision();
  const auto is_it = [&](const Held& one) { return one.network->revision() == revision; };
  const auto known = std::find_if(held_.begin(), held_.end(), is_it);
  Held held;
  if (known != held_.end()) {
    held.network = known->network;
    held_.erase(known);
  } else {
    if (held_.size() >= kMost) held_.pop_front();
    Result<std::shared_ptr<const Snapshot>> network = found(revision);
    if (!network) return network;
    held.network = *std::move(network);
  }
  held.until = now + kHeld;
  held_.push_back(held);
  return held.network;
}

void PastMaps::tick(SteadyTime now) {
  while (!held_.empty() && held_.front().until <= now) held_.pop_front();
}

std::optional<SteadyTime> PastMaps::next() const {
  if (held_.empty()) return std::nullopt;
  return held_.front().until;
}

}  // namespace weft::server
