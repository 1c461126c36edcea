#pragma once
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <optional>

#include "agents/agent/budget.hpp"
#include "core/bytes.hpp"
#include "core/protocol/messages.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// A content being put together from chunks in any order, any number of times, as it travels: coded.
class Assembly {
 public:
  explicit Assembly(std::uint64_t total, msg::Coding coding = msg::Coding::raw) : coding_(coding), bytes_(total) {}

  /// invalid: the chunk's coding or total differs or it reaches beyond it; nothing is taken of it.
  Result<void> add(const msg::Chunk& chunk);
  /// Everything before it is there: where to resume.
  std::uint64_t contiguous() const;
  bool complete() const { return contiguous() == bytes_.size(); }
  /// The chunk is of the same form.
  bool is_of(const msg::Chunk& chunk) const { return chunk.coding == coding_ && chunk.total == bytes_.size(); }
  /// Returns the bytes, valid when complete; not verified.
  const Bytes& bytes() const { return bytes_; }

 private:
  msg::Coding coding_;
  Bytes bytes_;
  std::map<std::uint64_t, std::uint64_t> have_;  ///< begin -> end, disjoint, not touching
};

/// Contents on their way out, cut into chunks, oldest request first.
class ChunkQueue {
 public:
  /// A content that is waiting already, or was sent a moment ago, is not queued twice.
  void push(const ContentHash& hash, std::uint64_t offset, SteadyTime now);
  bool empty() const { return queue_.empty(); }
  void clear();

  using Read = std::function<Result<Bytes>(const ContentHash&)>;
  /// The next chunk without its header and addressed to the server, if the budget has room for one. A content that
  /// cannot be read is dropped (its batch will be asked for again) and its error passed on.
  Result<std::optional<msg::Chunk>> next(Budget& budget, const Read& read, SteadyTime now);

 private:
  struct Item {
    ContentHash hash;
    std::uint64_t offset = 0;
  };
  std::deque<Item> queue_;
  std::optional<std::pair<ContentHash, Bytes>> open_;  ///< what is being cut at the moment
  std::map<ContentHash, SteadyTime> sent_;             ///< when a content's last chunk left
};

}  // namespace weft::agents
