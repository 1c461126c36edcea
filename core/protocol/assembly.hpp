#pragma once
#include <cstdint>
#include <map>

#include "core/bytes.hpp"
#include "core/ids.hpp"
#include "core/protocol/messages.hpp"
#include "core/result.hpp"

namespace weft {

/// Returns whether a chunk can be of a content of `size` bytes: compressed bytes are fewer, so nothing that a message
/// says takes more memory than what was asked for.
bool can_be_of(const msg::Chunk& chunk, std::uint64_t size);

/// Puts one content together as its chunks come in: in any order, any number of times, with any overlap, and coded as
/// they travel.
class Assembly {
 public:
  explicit Assembly(std::uint64_t total, msg::Coding coding = msg::Coding::raw) : coding_(coding), bytes_(total) {}

  /// Adds a chunk. invalid: it has another coding or states another size, or does not lie within it; nothing is taken
  /// of it.
  Result<void> add(const msg::Chunk& chunk);

  /// Returns where to resume: everything before it is there.
  std::uint64_t contiguous() const;
  bool is_complete() const { return contiguous() == bytes_.size(); }
  /// Returns whether the chunk is of the same size and coding.
  bool is_of(const msg::Chunk& chunk) const { return chunk.coding == coding_ && chunk.total == bytes_.size(); }

  /// Returns the bytes as they travel, of use once all are there; their hash has not been verified.
  const Bytes& bytes() const { return bytes_; }
  /// Gives the content away. corrupt: it is complete and not what was promised.
  Result<Bytes> take(const ContentHash& promised) &&;

 private:
  msg::Coding coding_;
  Bytes bytes_;
  std::map<std::uint64_t, std::uint64_t> have_;  ///< [begin, end), disjoint, not touching
};

}  // namespace weft
