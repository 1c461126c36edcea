#include "agents/agent/chunks.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "core/network/codec.hpp"

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

/// The server may ask again before it has seen what is under way.
constexpr Duration kUnderWay = 1s;
}  // namespace

Result<void> Assembly::add(const msg::Chunk& chunk) {
  if (!is_of(chunk) || chunk.offset > chunk.total || chunk.data.size() > chunk.total - chunk.offset) {
    return fail(ErrorCode::invalid, "chunk of " + to_string(chunk.hash) + ": " + std::to_string(chunk.data.size()) +
                                        " bytes at " + std::to_string(chunk.offset) + " of " +
                                        std::to_string(chunk.total) + ", expected " + std::to_string(bytes_.size()) +
                                        " in all, or of another coding");
  }
  if (chunk.data.empty()) return {};
  std::copy(chunk.data.begin(), chunk.data.end(), bytes_.begin() + static_cast<std::ptrdiff_t>(chunk.offset));
  std::uint64_t begin = chunk.offset;
  std::uint64_t end = chunk.offset + chunk.data.size();
  auto at = have_.upper_bound(begin);
  if (at != have_.begin() && std::prev(at)->second >= begin) --at;
  while (at != have_.end() && at->first <= end) {
    begin = std::min(begin, at->first);
    end = std::max(end, at->second);
    at = have_.erase(at);
  }
  have_.emplace(begin, end);
  return {};
}

std::uint64_t Assembly::contiguous() const {
  const auto first = have_.begin();
  return first == have_.end() || first->first != 0 ? 0 : first->second;
}

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
