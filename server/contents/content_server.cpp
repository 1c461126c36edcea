#include "server/contents/content_server.hpp"

#include <algorithm>
#include <utility>

#include "server/base/repeating.hpp"

namespace weft::server {
namespace {

constexpr double kBytesPerSecond = 4.0 * (1U << 20U);  ///< for each recipient
constexpr double kBurstBytes = 8.0 * msg::kChunkBytes;
constexpr std::size_t kMostWanted = 8192;

}  // namespace

static ContentSizes sizes_in(const Snapshot& snapshot) {
  ContentSizes::Sizes sizes;
  sizes.reserve(snapshot.place_count());
  for (const auto& [id, experience] : snapshot.experiences()) {
    for (const Place& place : experience->places) sizes.emplace_back(place.content.hash, place.content.size);
  }
  return ContentSizes(std::move(sizes));
}

ContentServer::ContentServer(Context& context) : context_(context), sizes_(sizes_in(context.snapshots.current())) {}

void ContentServer::joined(const Batch& batch) {
  for_each_place(batch, [&](const Place& place) { sizes_.add(place.content.hash, place.content.size); });
}

/// Returns the size of a content that can be served; none: nobody handed it in. Contents of a map of the past can be
/// asked for again after an undo: the store has them.
std::optional<std::uint64_t> ContentServer::size_of(const ContentHash& hash) {
  if (const std::optional<std::uint64_t> known = sizes_.find(hash)) return known;
  if (!context_.store.has_content(hash)) return std::nullopt;
  const Result<storage::StoredContent> stored = context_.store.stored_content(hash);
  if (!stored || stored->size == 0) return std::nullopt;
  sizes_.add(hash, stored->size);
  return stored->size;
}

void ContentServer::on_request(const msg::ContentRequest& request, SteadyTime now) {
  if (recipients_.size() >= kMostPeers && !recipients_.contains(request.header.sender)) {
    ++context_.counters["library: too many askers"];
    return;
  }
  const auto [at, is_new] = recipients_.try_emplace(request.header.sender);
  Recipient& recipient = at->second;
  if (is_new) {
    recipient.budget = kBurstBytes;
    recipient.budget_at = now;
  }
  for (const msg::ContentRequest::Item& item : request.items) {
    const std::optional<std::uint64_t> size = size_of(item.hash);
    if (!size) {
      ++context_.counters["library: content that nobody handed in"];
      continue;
    }
    if (item.offset >= *size || recipient.wanted.size() >= kMostWanted) continue;
    // Asked again while it is being sent: those bytes are on their way.
    recipient.wanted.emplace(Key{*size, item.hash}, item.offset);
  }
}

void ContentServer::refill(Recipient& recipient, SteadyTime now) const {
  recipient.budget = std::min(kBurstBytes, recipient.budget + kBytesPerSecond * seconds(now - recipient.budget_at));
  recipient.budget_at = now;
}

std::shared_ptr<const storage::StoredContent> ContentServer::fetch(const ContentHash& hash, Now now) {
  if (open_ != nullptr && open_hash_ == hash) return open_;
  Result<storage::StoredContent> content = context_.store.stored_content(hash);
  if (!content) {
    ++context_.counters["library: content cannot be read"];
    context_.writer.note({.at = {},
                          .kind = "library.content_damaged",
                          .robot = {},
                          .goal = {},
                          .cause = content.error().message,
                          .who = "server"},
                         now);
    sizes_.erase(hash);
    return nullptr;
  }
  open_hash_ = hash;
  open_ = std::make_shared<const storage::StoredContent>(*std::move(content));
  return open_;
}

void ContentServer::serve(const PeerId& peer, Recipient& recipient, Now now) {
  refill(recipient, now.steady);
  while (!recipient.wanted.empty() && recipient.budget >= 0.0) {
    const auto first = recipient.wanted.begin();
    const ContentHash hash = std::get<1>(first->first);
    const std::shared_ptr<const storage::StoredContent> content = fetch(hash, now);
    if (content == nullptr) {
      recipient.wanted.erase(first);
      continue;
    }
    const Bytes& bytes = content->bytes;
    // It began with another form of it, of a store before this one: the first chunk tells it so.
    if (first->second >= bytes.size()) first->second = 0;
    const std::uint64_t offset = first->second;
    const std::uint64_t size = std::min<std::uint64_t>(msg::kChunkBytes, bytes.size() - offset);
    const auto begin = bytes.begin() + static_cast<std::ptrdiff_t>(offset);
    context_.out.send(msg::Chunk{.header = {},
                                 .to = peer,
                                 .kind = msg::ContentKind::content,
                                 .coding = content->coding,
                                 .hash = hash,
                                 .total = bytes.size(),
                                 .offset = offset,
                                 .data = Bytes(begin, begin + static_cast<std::ptrdiff_t>(size))});
    recipient.budget -= static_cast<double>(size);
    first->second += size;
    if (first->second == bytes.size()) recipient.wanted.erase(first);
  }
}

void ContentServer::tick(Now now) {
  for (auto& [peer, recipient] : recipients_) {
    if (!recipient.wanted.empty()) serve(peer, recipient, now);
  }
}

std::optional<SteadyTime> ContentServer::next() const {
  std::optional<SteadyTime> next;
  for (const auto& [peer, recipient] : recipients_) {
    if (recipient.wanted.empty()) continue;
    // When a quarter of the burst can be sent at once: fewer, fuller wake-ups.
    const double lacking = std::max(0.0, kBurstBytes / 4 - recipient.budget);
    const SteadyTime due = recipient.budget_at + from_seconds(lacking / kBytesPerSecond);
    if (!next || due < *next) next = due;
  }
  return next;
}

std::size_t ContentServer::waiting() const {
  std::size_t all = 0;
  for (const auto& [peer, recipient] : recipients_) all += recipient.wanted.size();
  return all;
}

}  // namespace weft::server
