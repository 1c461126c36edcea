#pragma once
#include <cstdint>
#include <map>
#include <vector>

#include "core/ids.hpp"

namespace weft::storage {

/// The revisions that one revision is made of: all up to it, but for those that a rollback left behind.
class Lineage {
 public:
  /// The revisions from `first` to `last`, both included.
  struct Interval {
    std::uint64_t first = 0;
    std::uint64_t last = 0;
    bool operator==(const Interval&) const = default;
  };

  /// `bases`: what each rollback went back to, by its revision. Every other revision stands on the one before it.
  Lineage(Revision top, const std::map<Revision, Revision>& bases);

  bool contains(std::uint64_t revision) const;
  /// Newest first.
  const std::vector<Interval>& intervals() const { return intervals_; }
  /// The revisions that only one of the two is made of, oldest first.
  std::vector<Interval> differing(const Lineage& other) const;

 private:
  std::vector<Interval> intervals_;
};

}  // namespace weft::storage
