#pragma once
#include <cstdint>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "agents/agent/chunks.hpp"
#include "agents/agent/session.hpp"
#include "agents/navigation/map_view.hpp"
#include "core/network/network.hpp"
#include "core/protocol/messages.hpp"

namespace weft::agents {

/// The contents of the window, as many of them as fit: the nearest are asked for first and given up last.
class ContentCache final : public Contents {
 public:
  ContentCache(std::uint64_t most_bytes, std::uint64_t bytes_per_second);

  std::shared_ptr<const Bytes> find(const ContentHash& hash) const override;

  /// What the window names, nearest first; replaces what was wanted before.
  void want(const std::vector<ContentRef>& nearest_first, SteadyTime now);
  /// One's own, just taught.
  void put(const ContentHash& hash, Bytes bytes);
  /// True when it completed a content.
  bool on_chunk(const msg::Chunk& chunk, SteadyTime now);
  /// Everything that is under way is asked for again.
  void server_restarted(SteadyTime now);

  /// A request without its header, when it is time for one.
  std::optional<msg::ContentRequest> due(SteadyTime now);
  std::optional<SteadyTime> next() const;

  /// Of what is wanted and fits.
  std::size_t missing() const { return missing_.size() + incoming_.size(); }
  std::uint64_t bytes() const { return bytes_; }
  const Counters& counters() const { return counters_; }

 private:
  struct Held {
    std::shared_ptr<const Bytes> bytes;
    std::size_t rank = 0;  ///< nearness; what is not wanted has the last rank
  };
  struct Incoming {
    Assembly assembly;
    SteadyTime ask_at;
    Duration wait{};
  };
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
  Counters counters_;
};

}  // namespace weft::agents
