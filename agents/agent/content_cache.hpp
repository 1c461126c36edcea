#pragma once
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "agents/agent/session.hpp"
#include "agents/navigation/map_view.hpp"
#include "core/network/network.hpp"
#include "core/protocol/assembly.hpp"
#include "core/protocol/messages.hpp"
#include "storage/content_coder.hpp"

namespace weft::agents {

/// Holds the contents of the window, as many of them as fit: the nearest are asked for first and given up last. They
/// come as the server keeps them, are expanded and verified here, and counted by their own size.
class ContentCache final : public Contents {
 public:
  ContentCache(std::uint64_t most_bytes, std::uint64_t bytes_per_second);

  std::shared_ptr<const Bytes> find(const ContentHash& hash) const override;

  /// Asks for the contents that the window names, nearest first; replaces what was wanted before.
  void want(const std::vector<ContentRef>& nearest_first, SteadyTime now);
  /// Takes in a content of this robot's own, just taught.
  void put(const ContentHash& hash, Bytes bytes);
  /// Takes in a chunk. Returns true when it completed a content.
  bool on_chunk(const msg::Chunk& chunk, SteadyTime now);
  /// Asks again for everything that is under way.
  void server_restarted(SteadyTime now);

  /// Returns a request without its header, when it is time for one.
  std::optional<msg::ContentRequest> due(SteadyTime now);
  std::optional<SteadyTime> next() const;

  /// Returns how many contents are still to come, of those that are wanted and fit.
  std::size_t missing() const { return missing_.size() + incoming_.size(); }
  std::uint64_t bytes() const { return bytes_; }
  const Counters& counters() const { return counters_; }

 private:
  struct Held {
    std::shared_ptr<const Bytes> bytes;
    std::size_t rank = 0;  ///< nearness; what is not wanted has the last rank
  };
  struct Incoming {
    std::uint64_t size = 0;            ///< of the content itself
    std::optional<Assembly> assembly;  ///< from the first chunk on, which says how much travels
    SteadyTime ask_at;
    Duration wait{};

    std::uint64_t contiguous() const { return assembly.has_value() ? assembly->contiguous() : 0; }
  };
  /// Returns the content that the last chunk completed; none: what came is not what its hash says.
  std::optional<Bytes> expand(const msg::Chunk& last, const Incoming& incoming);
  std::size_t rank_of(const ContentHash& hash) const;
  void keep(const ContentHash& hash, Bytes bytes, std::size_t rank);
  void shrink();

  std::uint64_t most_bytes_;
  std::uint64_t under_way_most_;  ///< bytes asked for and not here
  std::uint64_t bytes_ = 0;
  std::map<ContentHash, Held> held_;
  std::vector<std::pair<ContentHash, std::size_t>> rank_;  ///< of everything wanted that fits, sorted
  std::list<ContentRef> missing_;                          ///< nearest first, not asked for yet
  std::map<ContentHash, Incoming> incoming_;
  std::uint64_t under_way_ = 0;
  SteadyTime ask_at_{};
  storage::ContentCoder coder_;
  Counters counters_;
};

}  // namespace weft::agents
