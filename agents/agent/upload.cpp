#include "agents/agent/upload.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/protocol/messages.hpp"

namespace weft::agents {
namespace {

/// Returns the burst size of the token bucket.
std::uint64_t burst(std::uint64_t bytes_per_second) {
  return std::max<std::uint64_t>(msg::kChunkBytes, bytes_per_second / 8);
}

}  // namespace

Upload::Upload(Spooler& spooler, std::uint64_t bytes_per_second, SteadyTime now)
    : spooler_(spooler), budget_(bytes_per_second, burst(bytes_per_second), now) {}

Result<void> Upload::send_batches(Outbox& outbox, SteadyTime now) {
  Result<std::vector<Batch>> batches = spooler_.due(now);
  if (!batches) return fail(batches.error());
  for (Batch& batch : *batches) outbox.send(msg::ExperienceBatch{.header = {}, .batch = std::move(batch)});
  return {};
}

void Upload::send_chunks(Outbox& outbox, SteadyTime now) {
  while (spooler_.has_chunks()) {
    Result<std::optional<msg::Chunk>> chunk = spooler_.next_chunk(budget_, now);
    if (!chunk) {
      outbox.note("spool: " + chunk.error().message);
      continue;
    }
    if (!chunk->has_value()) break;
    outbox.send(std::move(**chunk));
  }
}

std::optional<SteadyTime> Upload::next() const {
  std::optional<SteadyTime> next = spooler_.next();
  if (!spooler_.has_chunks()) return next;
  const SteadyTime affordable = budget_.when(msg::kChunkBytes);
  return next.has_value() ? std::min(*next, affordable) : affordable;
}

}  // namespace weft::agents
