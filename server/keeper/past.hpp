#pragma once
#include <deque>
#include <memory>
#include <optional>

#include "server/base/context.hpp"

namespace weft::server {

/// The network at revisions that somebody reads page by page: held until nobody has asked for them for a while, or
/// for too many others, because reading one from the store again costs what differs between it and now.
class Past {
 public:
  explicit Past(Context& context) : context_(context) {}

  /// As it was then; 0: as it is. refused: there is no such revision; otherwise as the store's `snapshot_at`.
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
