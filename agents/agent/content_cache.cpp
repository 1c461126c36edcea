#include "agents/agent/content_cache.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <utility>

#include "core/network/codec.hpp"

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr Duration kFetchAgain = 2s;
constexpr Duration kFetchAgainMost = 8s;
constexpr std::size_t kItems = 64;
constexpr std::size_t kUnwanted = std::numeric_limits<std::size_t>::max();
constexpr std::uint64_t kUnderWayLeast = 256 * 1024;

}  // namespace

ContentCache::ContentCache(std::uint64_t most_bytes, std::uint64_t bytes_per_second)
    : most_bytes_(most_bytes), under_way_most_(std::max(kUnderWayLeast, bytes_per_second / 2)) {}

std::shared_ptr<const Bytes> ContentCache::find(const ContentHash& hash) const {
  const auto found = held_.find(hash);
  return found == held_.end() ? nullptr : found->second.bytes;
}

void ContentCache::want(const std::vector<ContentRef>& nearest_first, SteadyTime now) {
  rank_.clear();
  std::uint64_t sum = 0;
  for (const ContentRef& content : nearest_first) {
    sum += content.size;
    if (sum > most_bytes_) break;
    rank_.emplace_back(content.hash, rank_.size());
  }
  std::vector<bool> is_missing(rank_.size(), true);
  std::sort(rank_.begin(), rank_.end());
  rank_.erase(std::unique(rank_.begin(), rank_.end(),
                          [&](const auto& first, const auto& again) {
                            if (first.first != again.first) return false;
                            is_missing[again.second] = false;
                            return true;
                          }),
              rank_.end());
  // Both are sorted: side by side.
  auto wanted = rank_.begin();
  for (auto& [hash, held] : held_) {
    while (wanted != rank_.end() && wanted->first < hash) ++wanted;
    const bool is_wanted = wanted != rank_.end() && wanted->first == hash;
    held.rank = is_wanted ? wanted->second : kUnwanted;
    if (is_wanted) is_missing[wanted->second] = false;
  }
  std::erase_if(incoming_, [&](const auto& entry) {
    const std::size_t rank = rank_of(entry.first);
    if (rank == kUnwanted) {
      under_way_ -= entry.second.size;
      return true;
    }
    is_missing[rank] = false;
    return false;
  });
  missing_.clear();
  for (std::size_t rank = 0; rank < is_missing.size(); ++rank) {
    if (is_missing[rank]) missing_.push_back(nearest_first[rank]);
  }
  if (!missing_.empty()) ask_at_ = now;
}

std::size_t ContentCache::rank_of(const ContentHash& hash) const {
  const auto found =
      std::lower_bound(rank_.begin(), rank_.end(), hash,
                       [](const auto& ranked, const ContentHash& other) { return ranked.first < other; });
  return found == rank_.end() || found->first != hash ? kUnwanted : found->second;
}

void ContentCache::put(const ContentHash& hash, Bytes bytes) {
  keep(hash, std::move(bytes), rank_of(hash));
}

void ContentCache::keep(const ContentHash& hash, Bytes bytes, std::size_t rank) {
  if (held_.contains(hash)) return;
  bytes_ += bytes.size();
  held_.emplace(hash, Held{std::make_shared<const Bytes>(std::move(bytes)), rank});
  shrink();
}

void ContentCache::shrink() {
  while (bytes_ > most_bytes_ && held_.size() > 1) {
    const auto farthest = std::max_element(
        held_.begin(), held_.end(), [](const auto& a, const auto& b) { return a.second.rank < b.second.rank; });
    bytes_ -= farthest->second.bytes->size();
    held_.erase(farthest);
  }
}

bool ContentCache::on_chunk(const msg::Chunk& chunk, SteadyTime now) {
  const auto found = incoming_.find(chunk.hash);
  if (found == incoming_.end()) {
    if (!held_.contains(chunk.hash)) ++counters_["chunk: not asked for"];
    return false;
  }
  Incoming& incoming = found->second;
  if (!can_be_of(chunk, incoming.size)) {
    ++counters_["chunk: out of bounds"];
    return false;
  }
  if (!incoming.assembly.has_value() || !incoming.assembly->is_of(chunk)) {
    if (incoming.assembly.has_value()) ++counters_["content: begun anew in another form"];
    incoming.assembly.emplace(chunk.total, chunk.coding);
  }
  if (!incoming.assembly->add(chunk)) return false;  // possible, so it is taken
  incoming.wait = kFetchAgain;
  incoming.ask_at = now + incoming.wait;
  if (!incoming.assembly->is_complete()) return false;
  std::optional<Bytes> bytes = expand(chunk, incoming);
  if (!bytes.has_value()) {
    incoming.assembly.reset();
    return false;
  }
  under_way_ -= incoming.size;
  incoming_.erase(found);
  ask_at_ = std::min(ask_at_, now);
  put(chunk.hash, std::move(*bytes));
  return true;
}

std::optional<Bytes> ContentCache::expand(const msg::Chunk& last, const Incoming& incoming) {
  Result<Bytes> bytes = coder_.decode(last.coding, incoming.assembly->bytes(), incoming.size);
  if (!bytes) {
    ++counters_["content: cannot be expanded"];
    return std::nullopt;
  }
  if (hash_bytes(*bytes) != last.hash) {
    ++counters_["content: hash differs"];
    return std::nullopt;
  }
  return *std::move(bytes);
}

void ContentCache::server_restarted(SteadyTime now) {
  for (auto& [hash, incoming] : incoming_) {
    incoming.ask_at = now;
    incoming.wait = kFetchAgain;
  }
}

std::optional<msg::ContentRequest> ContentCache::due(SteadyTime now) {
  msg::ContentRequest request;
  for (auto& [hash, incoming] : incoming_) {
    if (incoming.ask_at > now || request.items.size() == kItems) continue;
    request.items.push_back({.hash = hash, .offset = incoming.contiguous()});
    incoming.wait = std::min(incoming.wait * 2, kFetchAgainMost);
    incoming.ask_at = now + incoming.wait;
  }
  while (!missing_.empty() && request.items.size() < kItems) {
    const ContentRef next = missing_.front();
    if (under_way_ > 0 && under_way_ + next.size > under_way_most_) break;
    missing_.pop_front();
    if (held_.contains(next.hash) || next.size > msg::kContentBytes) continue;
    under_way_ += next.size;
    incoming_.emplace(next.hash, Incoming{next.size, std::nullopt, now + kFetchAgain, kFetchAgain});
    request.items.push_back({.hash = next.hash, .offset = 0});
  }
  if (request.items.empty()) return std::nullopt;
  return request;
}

std::optional<SteadyTime> ContentCache::next() const {
  std::optional<SteadyTime> next;
  for (const auto& [hash, incoming] : incoming_) {
    next = next.has_value() ? std::min(*next, incoming.ask_at) : incoming.ask_at;
  }
  const bool room = !missing_.empty() && (under_way_ == 0 || under_way_ + missing_.front().size <= under_way_most_);
  if (room) next = next.has_value() ? std::min(*next, ask_at_) : ask_at_;
  return next;
}

}  // namespace weft::agents
