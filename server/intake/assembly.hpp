#pragma once
#include <cstdint>
#include <map>
#include <utility>

#include "core/bytes.hpp"
#include "core/ids.hpp"
#include "core/protocol/messages.hpp"
#include "core/result.hpp"

namespace weft::server {

/// Puts one content together as its chunks come in: in any order, any number of times, with any overlap.
class Assembly {
 public:
  explicit Assembly(std::uint64_t total) : bytes_(total) {}

  /// Adds a chunk. invalid: it does not lie within the content, or states another size.
  Result<void> add(const msg::Chunk& chunk);
  bool is_complete() const;
  /// Returns the content. corrupt: it is complete and not what was promised.
  Result<Bytes> take(const ContentHash& promised) &&;
  std::uint64_t size() const { return bytes_.size(); }

 private:
  Bytes bytes_;
  std::map<std::uint64_t, std::uint64_t> have_;  // [begin, end), disjoint, not touching
};

}  // namespace weft::server
