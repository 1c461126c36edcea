#pragma once
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "storage/retention.hpp"
#include "storage/sqlite/parts.hpp"

/// Does a compaction in pieces; docs/formats/store.md says what goes and why nothing else is missed.
namespace weft::storage::sqlite {

/// Holds the state that all pieces of a compaction share. Moves are read again when others were committed.
class Compaction {
 public:
  static Result<std::unique_ptr<Compaction>> make(Parts& parts, Revision floor);

  Parts& parts() const { return *parts_; }
  const Retention& retention() const { return retention_; }
  /// Returns the retention of one experience's places; valid until the next call.
  Result<const PlaceRetention*> places_of(ExperienceId id);
  Result<const std::vector<Moved>*> moves_of(const EdgeId& stitch);

  /// Makes one write transaction: nothing of `work` is there unless all of it is. `work` may change the store's row.
  Result<void> write(const std::function<Result<void>(StoreRow&)>& work);
  /// Returns the contents that commits have named since the compaction began.
  const std::set<ContentHash>& used_meanwhile() const { return *used_; }

  struct Deleted {
    std::uint64_t places = 0, edges = 0, labels = 0, revisions = 0, contents = 0, content_bytes = 0;
  };
  Deleted deleted;

 private:
  Compaction(Parts& parts, Retention retention) : parts_(&parts), retention_(std::move(retention)) {}
  Result<void> read_moves();

  Parts* parts_;
  Retention retention_;
  std::uint64_t moves_read_ = 0;  ///< Parts::moves + 1 at the last reading
  std::map<ExperienceId, std::vector<MovedStretch>> moved_places_;
  std::map<EdgeId, std::vector<Moved>> moved_stitches_;
  std::optional<std::pair<ExperienceId, PlaceRetention>> places_of_;
  std::shared_ptr<std::set<ContentHash>> used_;
};

class CompactPart {
 public:
  virtual ~CompactPart() = default;
  /// Does a bounded piece. Returns true when there may be more.
  virtual Result<bool> step(Compaction& compaction) = 0;
  virtual std::uint64_t done() const = 0;  ///< rows looked at
};
using CompactParts = std::vector<std::unique_ptr<CompactPart>>;

/// Adds the pieces for the map in the order in which they must run: places are marked, then edges, places, labels and
/// moves go.
Result<void> add_map_compaction(const Parts& parts, CompactParts& to);
/// Adds the pieces for revisions, contents, and the file's free pages.
Result<void> add_rest_compaction(const Parts& parts, CompactParts& to);

}  // namespace weft::storage::sqlite
