#include "server/intake/assembly.hpp"

#include <algorithm>
#include <string>

#include "core/network/codec.hpp"

namespace weft::server {

Result<void> Assembly::add(const msg::Chunk& chunk) {
  const std::uint64_t total = bytes_.size();
  if (chunk.total != total || chunk.data.size() > total || chunk.offset > total - chunk.data.size()) {
    return fail(ErrorCode::invalid, "chunk at " + std::to_string(chunk.offset) + " of " +
                                        std::to_string(chunk.data.size()) + " bytes, content of " +
                                        std::to_string(chunk.total) + " bytes; promised were " +
                                        std::to_string(total));
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

bool Assembly::is_complete() const {
  if (bytes_.empty()) return true;
  return have_.size() == 1 && have_.begin()->first == 0 && have_.begin()->second == bytes_.size();
}

Result<Bytes> Assembly::take(const ContentHash& promised) && {
  if (hash_bytes(bytes_) != promised) {
    return fail(ErrorCode::corrupt, "the bytes that came for content " + to_string(promised) + " hash to " +
                                        to_string(hash_bytes(bytes_)));
  }
  return std::move(bytes_);
}

}  // namespace weft::server
