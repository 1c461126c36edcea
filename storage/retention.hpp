#pragma once
#include <cstdint>
#include <map>
#include <vector>

#include "core/network/removal.hpp"
#include "storage/lineage.hpp"

/// Decides which rows may be deleted for good when all maps older than one revision, the floor, are given up. Pure,
/// the same for every engine; docs/formats/store.md says why it is right.
namespace weft::storage {

/// Finds the kept maps that do not stand on another kept one: that of the floor, and of each later rollback to before
/// it. Every map from the floor on is one of them with rows added.
class Retention {
 public:
  /// Takes the `bases` of every rollback, as Lineage does. From now on nothing goes back behind the floor.
  Retention(Revision floor, const std::map<Revision, Revision>& bases);

  Revision floor() const { return floor_; }
  const std::vector<Lineage>& roots() const { return roots_; }

 private:
  Revision floor_;
  std::vector<Lineage> roots_;
};

/// Tells at which revision something left a map or came back.
struct Moved {
  std::uint64_t revision = 0;
  bool is_back = false;
};
struct MovedStretch : Moved {
  std::uint32_t first = 0;
  std::uint32_t last = 0;
};

/// Decides which places of one experience are kept.
class PlaceRetention {
 public:
  /// Takes `moves` in the order of (revision, is_back).
  PlaceRetention(const Retention& retention, const std::vector<MovedStretch>& moves);
  /// Returns whether the place that a revision added is in a kept map, or can come back to one.
  bool keeps(std::uint32_t index, std::uint64_t revision) const;

 private:
  /// Holds a truth value for every index, as the stretches over which it is the same.
  class Marks {
   public:
    void set(std::uint32_t first, std::uint32_t last, bool value);
    bool at(std::uint32_t index) const;

   private:
    std::map<std::uint64_t, bool> from_;
  };

  const Retention* retention_;
  std::vector<Marks> out_;  ///< a root each
  Marks touched_;           ///< by what a kept revision can undo
};

/// Decides which rows of one key are kept, of which the last in a lineage counts: the edges of a pair, the meanings
/// of a label. Asked from the newest row to the oldest.
class LatestRetention {
 public:
  explicit LatestRetention(const Retention& retention)
      : retention_(&retention), is_superseded_(retention.roots().size()) {}
  /// Returns whether the row of that revision is kept. `moves` of a stitch, in the order of (revision, is_back);
  /// labels have none.
  bool keeps(std::uint64_t revision, const std::vector<Moved>& moves = {});

 private:
  const Retention* retention_;
  std::vector<bool> is_superseded_;  ///< a root each
};

/// Returns them sorted, without overlaps, and joined where one goes on behind the other. All are of one experience.
std::vector<Stretch> joined(std::vector<Stretch> stretches);

}  // namespace weft::storage
