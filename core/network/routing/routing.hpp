#pragma once
#include <memory>
#include <optional>

#include "core/bytes.hpp"
#include "core/network/routing/preparation.hpp"
#include "core/network/search.hpp"

namespace weft::routing {

class Work;

/// Makes a preparation in steps, so that the caller can do other things in between.
class Builder {
 public:
  /// Begins a preparation from nothing.
  static Builder to_prepare(const Snapshot& snapshot, const std::set<std::string>& methods);
  /// Begins a preparation from an earlier one, as `update` makes it.
  static Builder to_update(const Preparation& preparation, const Snapshot& snapshot);
  /// Begins a preparation from stored bytes, with the errors of `decode`; the bytes are read at once.
  static Result<Builder> to_resume(ByteView bytes, const Snapshot& snapshot);

  explicit Builder(std::unique_ptr<Work> work);
  ~Builder();
  Builder(Builder&&) noexcept;
  Builder& operator=(Builder&&) noexcept;

  /// Does about `budget` places' worth of work, a place being about a microsecond, or one indivisible piece of it (of
  /// a million places the longest takes a fraction of a second: docs/decisions/042). Returns false when it is done.
  bool step(std::size_t budget);
  /// Returns the share of the work that is done, [0, 1].
  double share_done() const;
  /// Gives the preparation away, once, when it is done.
  Preparation take();
  /// Does all that is left, and takes it.
  Preparation finish();

 private:
  std::unique_ptr<Work> work_;
};

Preparation prepare(const Snapshot& snapshot, const std::set<std::string>& methods);

/// Returns the preparation for another revision of the same network, sharing with the old one what did not change.
/// Its time grows with what changed, its length and neighbourhood; many changes at once take less than one by one. It
/// answers as one by `prepare` would; searches become slower when a network grows to a multiple of what it was.
Preparation update(const Preparation& preparation, const Snapshot& snapshot);

/// Finds a least-cost way like `weft::shortest_path`, over a preparation for this very snapshot. The cost is the sum
/// of the norms of the edges' relations: metres, in which a turn counts as its angle times 0.5 m
/// (core/network/relation.hpp). Of several ways of equal cost any one is taken, the same one each time. None: there
/// is no way, or one of the places is not there. stale: the preparation is for another revision. invalid: it is for
/// other methods.
Result<std::optional<Path>> find_path(const Preparation& preparation, const Snapshot& snapshot, const PlaceId& from,
                                      const PlaceId& to, const std::set<std::string>& methods);

/// Does the same; where there is no way, asks `weft::shortest_path` for the words, which takes as long as it takes.
Result<Path> shortest_path(const Preparation& preparation, const Snapshot& snapshot, const PlaceId& from,
                           const PlaceId& to, const std::set<std::string>& methods);

/// Returns canonical bytes for the store (docs/formats/routes.md): which cells there are, the costs through them, and
/// what they were computed of.
Bytes encode(const Preparation& preparation);
/// Returns the preparation for `snapshot`, whichever revision the bytes were made of: what they say is compared with
/// the network, and what differs is computed anew. corrupt: short, trailing, or impossible values, which are named.
Result<Preparation> decode(ByteView bytes, const Snapshot& snapshot);

}  // namespace weft::routing
