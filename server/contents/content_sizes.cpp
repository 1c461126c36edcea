#include "server/contents/content_sizes.hpp"

#include <algorithm>

namespace weft::server {

ContentSizes::ContentSizes(Sizes from_start) : from_start_(std::move(from_start)) {
  std::sort(from_start_.begin(), from_start_.end());
  const auto is_same = [](const auto& a, const auto& b) { return a.first == b.first; };
  from_start_.erase(std::unique(from_start_.begin(), from_start_.end(), is_same), from_start_.end());
  from_start_.shrink_to_fit();
}

std::size_t ContentSizes::position(const ContentHash& hash) const {
  const auto is_before = [](const auto& entry, const ContentHash& wanted) { return entry.first < wanted; };
  const auto found = std::lower_bound(from_start_.begin(), from_start_.end(), hash, is_before);
  const bool is_there = found != from_start_.end() && found->first == hash && found->second != 0;
  return is_there ? static_cast<std::size_t>(found - from_start_.begin()) : from_start_.size();
}

void ContentSizes::add(const ContentHash& hash, std::uint64_t size) {
  if (position(hash) == from_start_.size()) since_.emplace(hash, size);
}

void ContentSizes::erase(const ContentHash& hash) {
  since_.erase(hash);
  if (const std::size_t at = position(hash); at < from_start_.size()) from_start_[at].second = 0;
}

std::optional<std::uint64_t> ContentSizes::find(const ContentHash& hash) const {
  if (const std::size_t at = position(hash); at < from_start_.size()) return from_start_[at].second;
  const auto found = since_.find(hash);
  return found == since_.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace weft::server
