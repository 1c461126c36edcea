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

/// Queues contents on their way out, cut into chunks, oldest request first.
class ChunkQueue {
 public:
  /// Queues a content, from `offset` bytes on, unless it is waiting already or was sent a moment ago.
  void push(const ContentHash& hash, std::uint64_t offset, SteadyTime now);
  bool empty() const { return queue_.empty(); }
  void clear();

  using Read = std::function<Result<Bytes>(const ContentHash&)>;
  /// Returns the next chunk, without its header and addressed to the server, if the budget has room for one. A
  /// content that cannot be read is dropped (its batch will be asked for again) and its error passed on.
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
