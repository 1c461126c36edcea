#pragma once
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <optional>

#include "agents/methods/method.hpp"
#include "agents/navigation/map_view.hpp"
#include "core/network/network.hpp"

namespace weft::agents {

/// Keeps contents in the method's own form, so many bytes of them at most as they are encoded, the least recently
/// used forgotten first; the newest stays, however large. Signatures, which are small, are kept for longer.
template <Method M>
class DecodedContents {
 public:
  using Content = typename M::Content;
  using Pointer = std::shared_ptr<const Content>;

  DecodedContents(const M& method, std::uint64_t most_bytes) : method_(&method), most_bytes_(most_bytes) {}

  /// Returns a place's content. Refused: "content_missing" (not arrived), "other_method", "content_damaged".
  OrRefusal<Pointer> find(const Place& place, const Contents& bytes) {
    const auto known = by_hash_.find(place.content.hash);
    if (known != by_hash_.end()) {
      used_.splice(used_.begin(), used_, known->second);
      return used_.front().content;
    }
    // Which of the older ones it still reads, the method says.
    if (place.method != M::name || place.content_format > newest_format<M>()) {
      return tl::unexpected(Refusal{"other_method"});
    }
    const std::shared_ptr<const Bytes> found = bytes.find(place.content.hash);
    if (!found) return tl::unexpected(Refusal{"content_missing"});
    Result<Content> decoded = method_->decode(*found);
    if (!decoded) return tl::unexpected(Refusal{"content_damaged"});
    Pointer content = std::make_shared<const Content>(std::move(*decoded));
    keep(place.content.hash, content, found->size());
    return content;
  }

  void keep(const ContentHash& hash, Pointer content, std::uint64_t size) {
    const auto known = by_hash_.find(hash);
    if (known != by_hash_.end()) return;
    used_.push_front({hash, std::move(content), size});
    by_hash_[hash] = used_.begin();
    bytes_ += size;
    while (bytes_ > most_bytes_ && used_.size() > 1) {
      bytes_ -= used_.back().size;
      by_hash_.erase(used_.back().hash);
      used_.pop_back();
    }
  }

  /// Returns whether `signature` has been asked for this content before.
  bool has_signature(const ContentHash& hash) const { return signatures_.contains(hash); }
  /// Returns a place's signature. None: the method gives none, or the content cannot be read.
  const std::optional<Signature>& signature(const Place& place, const Contents& bytes) {
    const auto known = signatures_.find(place.content.hash);
    if (known != signatures_.end()) return known->second;
    constexpr std::size_t most_signatures = 20'000;
    if (signatures_.size() >= most_signatures) signatures_.clear();
    const OrRefusal<Pointer> content = find(place, bytes);
    std::optional<Signature> signature;
    if (content) signature = method_->sign(**content);
    return signatures_.emplace(place.content.hash, std::move(signature)).first->second;
  }

 private:
  struct Entry {
    ContentHash hash;
    Pointer content;
    std::uint64_t size = 0;
  };
  const M* method_;
  std::uint64_t most_bytes_;
  std::uint64_t bytes_ = 0;  // of used_
  std::list<Entry> used_;    // most recently used first
  std::map<ContentHash, typename std::list<Entry>::iterator> by_hash_;
  std::map<ContentHash, std::optional<Signature>> signatures_;
};

}  // namespace weft::agents
