#pragma once
#include <deque>
#include <memory>
#include <optional>

#include "server/base/context.hpp"

namespace weft::server {

/// Holds the network at revisions that somebody reads page by page, until nobody has asked for one for a while or too
/// many others are asked for: reading one from the store again costs what differs between it and now.
class PastMaps {
 public:
  explicit PastMaps(Context& context) : context_(context) {}

  /// Returns the network as it was then; 0: as it is. refused: there is no such revision; otherwise as the store's
  /// `snapshot_at`.
  Result<std::shared_ptr<const Snapshot>> at(Revision revision, SteadyTime now);
  /// Lets go of what nobody reads any more.
  void tick(SteadyTime now);
  std::optional<SteadyTime> next() const;

 private:
  struct Held {
    std::shared_ptr<const Snapshot> network;
    SteadyTime until;
  };
  Result<std::shared_ptr<const Snapshot>> found(Revision revision) const;

  Context& context_;
  std::deque<Held> held_;  ///< what was asked for last, last
};

}  // namespace weft::server
