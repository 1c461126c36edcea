#pragma once
#include <cstdint>
#include <map>
#include <vector>

#include "core/ids.hpp"

namespace weft::storage {

/// Lists the revisions that one revision is made of: all up to it, but for those that a rollback left behind.
class Lineage {
 public:
  /// Spans the revisions from `first` to `last`, both included.
  struct Interval {
    std::uint64_t first = 0;
    std::uint64_t last = 0;
    bool operator==(const Interval&) const = default;
  };

  /// Takes `bases`: what each rollback went back to, by its revision. All other revisions stand on the one before.
  Lineage(Revision top, const std::map<Revision, Revision>& bases);

  bool contains(std::uint64_t revision) const;
  /// Returns the intervals, newest first.
  const std::vector<Interval>& intervals() const { return intervals_; }
  /// Returns the revisions that only one of the two is made of, oldest first.
  std::vector<Interval> differing(const Lineage& other) const;

 private:
  std::vector<Interval> intervals_;
};

}  // namespace weft::storage
