#include "core/protocol/assembly.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "core/network/codec.hpp"

namespace weft {

bool can_be_of(const msg::Chunk& chunk, std::uint64_t size) {
  const bool has_room = chunk.coding == msg::Coding::raw ? chunk.total == size : chunk.total < size;
  return has_room && chunk.offset <= chunk.total && chunk.data.size() <= chunk.total - chunk.offset;
}

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

Result<Bytes> Assembly::take(const ContentHash& promised) && {
  if (hash_bytes(bytes_) != promised) {
    return fail(ErrorCode::corrupt, "the bytes that came for content " + to_string(promised) + " hash to " +
                                        to_string(hash_bytes(bytes_)));
  }
  return std::move(bytes_);
}

}  // namespace weft
