#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>

#include "core/protocol/messages.hpp"
#include "server/base/context.hpp"
#include "server/library/content_sizes.hpp"

namespace weft::server {

/// Lends contents as they are stored, which the asker expands: each asker gets what it asked for in chunks, small
/// contents first, within a budget of bytes a second, so that nothing small ever waits behind something big.
class Shelf {
 public:
  explicit Shelf(Context& context);

  void on_request(const msg::ContentRequest& request, SteadyTime now);
  /// These contents can be asked for from now on.
  void joined(const Batch& batch);
  void tick(Now now);
  std::optional<SteadyTime> next() const;

 private:
  using Key = std::tuple<std::uint64_t, ContentHash>;  ///< the content's own size first: small before big
  struct Asker {
    std::map<Key, std::uint64_t> wanted;  ///< and from which offset among its coded bytes on
    double budget = 0.0;                  ///< bytes that may be sent now
    SteadyTime budget_at;
  };

  std::optional<std::uint64_t> size_of(const ContentHash& hash);
  void refill(Asker& asker, SteadyTime now) const;
  void serve(const PeerId& peer, Asker& asker, Now now);
  std::shared_ptr<const storage::StoredContent> fetch(const ContentHash& hash, Now now);

  Context& context_;
  ContentSizes sizes_;
  std::map<PeerId, Asker> askers_;
  ContentHash open_hash_;  ///< the content read last, so that its chunks do not read it again each
  std::shared_ptr<const storage::StoredContent> open_;
};

}  // namespace weft::server
