#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "core/network/network.hpp"
#include "core/protocol/assembly.hpp"
#include "core/protocol/messages.hpp"
#include "core/result.hpp"
#include "core/time.hpp"
#include "storage/content_coder.hpp"

namespace weft::cli {

/// Fetches contents from the server as an agent does: so many at a time, expanded and verified as they come, and
/// asked for again from where they stopped. Nothing is kept: each content is handed on once, in the order in which it
/// is whole.
class ContentFetcher {
 public:
  using Take = std::function<Result<void>(const ContentHash& hash, Bytes bytes)>;

  /// Fetches each of `wanted` once, however often it is named.
  ContentFetcher(const std::vector<ContentRef>& wanted, Take take);

  /// Returns a request without its header, when it is time for one.
  std::optional<msg::ContentRequest> due(SteadyTime now);

  /// Takes in a chunk; one that was not asked for is ignored. corrupt: it completes a content whose bytes are not
  /// what its hash says. Errors of `take`.
  Result<void> hear(const msg::Chunk& chunk, SteadyTime now);

  bool done() const { return fetched_ == wanted_.size(); }
  std::size_t fetched() const { return fetched_; }
  std::size_t wanted() const { return wanted_.size(); }
  /// Returns how many bytes have come, as they travel: it grows for as long as the server sends.
  std::uint64_t received() const { return received_; }

 private:
  struct Incoming {
    std::uint64_t size = 0;            ///< of the content itself
    std::optional<Assembly> assembly;  ///< from the first chunk on, which says how much travels
  };

  /// Hands on a content that is whole.
  Result<void> finish(const ContentHash& hash, const Incoming& incoming, msg::Coding coding);

  std::vector<ContentRef> wanted_;
  Take take_;
  std::size_t next_ = 0;  ///< of `wanted_`: not asked for yet
  std::map<ContentHash, Incoming> incoming_;
  std::size_t fetched_ = 0;
  std::uint64_t received_ = 0;
  SteadyTime repeat_at_{};
  storage::ContentCoder coder_;
};

}  // namespace weft::cli
