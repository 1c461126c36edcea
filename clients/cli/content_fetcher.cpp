#include "clients/cli/content_fetcher.hpp"

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "core/network/codec.hpp"

namespace weft::cli {
namespace {
using namespace std::chrono_literals;

constexpr std::size_t kContentsUnderWay = 64;
constexpr Duration kAskAgain = 2s;

std::vector<ContentRef> once_each(std::vector<ContentRef> contents) {
  std::ranges::sort(contents);
  const auto rest = std::ranges::unique(contents, {}, &ContentRef::hash);
  contents.erase(rest.begin(), rest.end());
  return contents;
}

}  // namespace

ContentFetcher::ContentFetcher(const std::vector<ContentRef>& wanted, Take take)
    : wanted_(once_each(wanted)), take_(std::move(take)) {}

std::optional<msg::ContentRequest> ContentFetcher::due(SteadyTime now) {
  msg::ContentRequest request;
  if (now >= repeat_at_) {
    for (const auto& [hash, incoming] : incoming_)
      request.items.push_back({hash, incoming.assembly ? incoming.assembly->contiguous() : 0});
  }
  for (; incoming_.size() < kContentsUnderWay && next_ < wanted_.size(); ++next_) {
    incoming_.emplace(wanted_[next_].hash, Incoming{wanted_[next_].size, {}});
    request.items.push_back({wanted_[next_].hash, 0});
  }
  if (request.items.empty()) return std::nullopt;
  repeat_at_ = now + kAskAgain;
  return request;
}

Result<void> ContentFetcher::hear(const msg::Chunk& chunk, SteadyTime now) {
  const auto found = incoming_.find(chunk.hash);
  if (found == incoming_.end() || !can_be_of(chunk, found->second.size)) return {};
  Incoming& incoming = found->second;
  if (!incoming.assembly.has_value() || !incoming.assembly->is_of(chunk))
    incoming.assembly.emplace(chunk.total, chunk.coding);
  if (!incoming.assembly->add(chunk)) return {};  // possible, so it is taken
  received_ += chunk.data.size();
  repeat_at_ = now + kAskAgain;
  if (!incoming.assembly->is_complete()) return {};
  const Incoming whole = std::move(incoming);
  incoming_.erase(found);
  return finish(chunk.hash, whole, chunk.coding);
}

Result<void> ContentFetcher::finish(const ContentHash& hash, const Incoming& incoming, msg::Coding coding) {
  Result<Bytes> bytes = coder_.decode(coding, incoming.assembly->bytes(), incoming.size);
  if (!bytes || hash_bytes(*bytes) != hash)
    return fail(ErrorCode::corrupt,
                "content " + to_string(hash) + " came damaged from the server; weft map check says which are");
  ++fetched_;
  return take_(hash, *std::move(bytes));
}

}  // namespace weft::cli
