#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>

#include "core/protocol/messages.hpp"
#include "server/base/context.hpp"
#include "server/contents/content_sizes.hpp"

namespace weft::server {

/// Serves contents as they are stored, which the recipient expands: each recipient gets what it asked for in chunks,
/// small contents first, within a budget of bytes a second, so that nothing small ever waits behind something big.
class ContentServer {
 public:
  explicit ContentServer(Context& context);

  void on_request(const msg::ContentRequest& request, SteadyTime now);
  /// Serves the contents of this batch from now on.
  void joined(const Batch& batch);
  void tick(Now now);
  std::optional<SteadyTime> next() const;

  /// Returns how many contents were asked for and are not sent yet, by all robots together.
  std::size_t waiting() const;

 private:
  using Key = std::tuple<std::uint64_t, ContentHash>;  ///< the content's own size first: small before big
  struct Recipient {
    std::map<Key, std::uint64_t> wanted;  ///< and from which offset among its coded bytes on
    double budget = 0.0;                  ///< bytes that may be sent now
    SteadyTime budget_at;
  };

  std::optional<std::uint64_t> size_of(const ContentHash& hash);
  void refill(Recipient& recipient, SteadyTime now) const;
  void serve(const PeerId& peer, Recipient& recipient, Now now);
  std::shared_ptr<const storage::StoredContent> fetch(const ContentHash& hash, Now now);

  Context& context_;
  ContentSizes sizes_;
  std::map<PeerId, Recipient> recipients_;
  ContentHash open_hash_;  ///< the content read last, so that its chunks do not read it again each
  std::shared_ptr<const storage::StoredContent> open_;
};

}  // namespace weft::server
