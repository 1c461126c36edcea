#pragma once
#include <cstddef>
#include <deque>
#include <memory>

#include "core/network/network.hpp"

namespace weft::server {

/// Keeps the network as it is, and as it was at its latest revisions. Revisions share what did not change. The map
/// writer owns the one that is served; everybody else reads it.
class Snapshots {
 public:
  /// Begins with `first`. `kept`: how many revisions can still be the base of a patch.
  explicit Snapshots(Snapshot first, std::size_t kept = 256) : kept_(kept) { push(std::move(first)); }

  const Snapshot& current() const { return *ring_.back(); }
  std::shared_ptr<const Snapshot> shared_current() const { return ring_.back(); }
  /// Makes `next` the newest one from here on.
  void push(Snapshot next) {
    ring_.push_back(std::make_shared<const Snapshot>(std::move(next)));
    if (ring_.size() > kept_) ring_.pop_front();
  }
  /// Returns null when that revision is older than what is kept.
  std::shared_ptr<const Snapshot> at(Revision revision) const {
    for (auto found = ring_.rbegin(); found != ring_.rend(); ++found) {
      if ((*found)->revision() == revision) return *found;
    }
    return nullptr;
  }

 private:
  std::size_t kept_;
  std::deque<std::shared_ptr<const Snapshot>> ring_;  // never empty, oldest first
};

}  // namespace weft::server
