#pragma once
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "agents/methods/recognition/code.hpp"
#include "core/network/network.hpp"

namespace weft::agents {

/// Holds the coded signatures of a network's places, all of one method and content format. They are derived from
/// contents, so never stored. About 260 bytes a place of the method `floor`.
class RecognitionIndex {
 public:
  static constexpr std::uint32_t chunk_places = 256;
  /// Holds the codes of consecutive places of one experience.
  struct Chunk {
    std::vector<std::uint8_t> codes;  ///< in the order of places, up to the last that is signed
    std::bitset<chunk_places> is_signed;
  };
  using ChunkKey = std::pair<ExperienceId, std::uint32_t>;  ///< index of the place / chunk_places

  /// Puts a signature. False, nothing put: no number or too many, one is not finite, or not as many as those before.
  bool put(const PlaceId& id, const Signature& signature);
  bool has(const PlaceId& id) const;
  void forget(ExperienceId experience);

  std::size_t size() const { return size_; }
  /// Returns whether this can be looked for: it is as long as those that were put.
  bool fits(const Signature& seen) const { return !seen.empty() && seen.size() == numbers_; }
  std::size_t numbers() const { return numbers_; }  ///< of each signature; 0 while there is none
  std::size_t memory_bytes() const { return memory_bytes_; }
  const std::map<ChunkKey, Chunk>& chunks() const { return chunks_; }
  const UsualLevels& usual() const { return usual_; }

 private:
  void discount(const Chunk& chunk);

  std::size_t numbers_ = 0;
  std::size_t size_ = 0;
  std::size_t memory_bytes_ = 0;
  std::map<ChunkKey, Chunk> chunks_;
  UsualLevels usual_;
};

struct Likely {
  std::int32_t likeness = 0;  ///< larger is more alike
  PlaceId place;
};

/// Compares one signature with all of an index, a piece at a time. The index may change between pieces.
class RecognitionSearch {
 public:
  /// Begins to look for `seen`, which the index fits. `keep`: how many of the likeliest are wanted.
  RecognitionSearch(const RecognitionIndex& index, const Signature& seen, std::size_t keep)
      : query_(seen, index.usual()), keep_(keep) {}

  /// Compares about `places` more. Only places that are in `now` may be among the likeliest. Returns false when it
  /// has seen all.
  bool step(const RecognitionIndex& index, const Snapshot& now, std::size_t places);
  /// Returns the likeliest first, ties by id.
  std::vector<PlaceId> ranked() const;

 private:
  void compare(const RecognitionIndex::ChunkKey& key, const RecognitionIndex::Chunk& chunk, const Snapshot& now);
  void offer(const Likely& likely, const Snapshot& now);

  CodeQuery query_;
  std::size_t keep_;
  std::optional<RecognitionIndex::ChunkKey> done_;  ///< the last chunk that was compared
  std::vector<Likely> best_;                        ///< a heap, the least likely of them first
  std::vector<std::int32_t> likeness_;              ///< of one chunk
};

/// Says which of the likeliest places are wanted: `most` of those behind the first `after`.
struct Wanted {
  std::size_t most = 64;
  std::size_t after = 0;
};
/// Returns how many of the likeliest a search keeps, so that there are enough when they are spread out.
std::size_t kept_for(const Wanted& wanted);

/// Returns places of `ranked`, in that order, no more than two within three hops of one another: each leads to its
/// neighbours.
std::vector<PlaceId> spread_out(const Snapshot& snapshot, const std::vector<PlaceId>& ranked, const Wanted& wanted);

/// Returns places of the network that look like `seen`, the likeliest first, spread out; searches all at once. The
/// index fits `seen`.
std::vector<PlaceId> likeliest(const RecognitionIndex& index, const Snapshot& snapshot, const Signature& seen,
                               const Wanted& wanted);

}  // namespace weft::agents
