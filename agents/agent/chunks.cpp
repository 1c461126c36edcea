#include "agents/agent/chunks.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

/// Sets for how long after a content was sent it is not sent again: the server may ask before it has seen it.
constexpr Duration kUnderWay = 1s;
}  // namespace

void ChunkQueue::push(const ContentHash& hash, std::uint64_t offset, SteadyTime now) {
  std::erase_if(sent_, [&](const auto& entry) { return now - entry.second > kUnderWay; });
  const bool waits = std::any_of(queue_.begin(), queue_.end(), [&](const Item& item) { return item.hash == hash; });
  if (!waits && !sent_.contains(hash)) queue_.push_back({hash, offset});
}

void ChunkQueue::clear() {
  queue_.clear();
  open_.reset();
  sent_.clear();
}

Result<std::optional<msg::Chunk>> ChunkQueue::next(Budget& budget, const Read& read, SteadyTime now) {
  if (queue_.empty()) return std::optional<msg::Chunk>{};
  Item& item = queue_.front();
  if (!open_.has_value() || open_->first != item.hash) {
    Result<Bytes> bytes = read(item.hash);
    if (!bytes) {
      queue_.pop_front();
      return fail(bytes.error());
    }
    open_.emplace(item.hash, std::move(*bytes));
  }
  const Bytes& bytes = open_->second;
  item.offset = std::min<std::uint64_t>(item.offset, bytes.size());
  const std::uint64_t size = std::min<std::uint64_t>(msg::kChunkBytes, bytes.size() - item.offset);
  if (!budget.take(size, now)) return std::optional<msg::Chunk>{};
  const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(item.offset);
  msg::Chunk chunk;
  chunk.hash = item.hash;
  chunk.total = bytes.size();
  chunk.offset = item.offset;
  chunk.data.assign(begin, begin + static_cast<std::ptrdiff_t>(size));
  item.offset += size;
  if (item.offset == bytes.size()) {
    sent_[item.hash] = now;
    queue_.pop_front();
    open_.reset();
  }
  return std::optional<msg::Chunk>{std::move(chunk)};
}

}  // namespace weft::agents
