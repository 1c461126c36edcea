#include "server/fleet/protocol.hpp"

#include <algorithm>
#include <string>

namespace weft::server {
namespace {
/// Version N and N - 1; the first version has none before it.
constexpr std::uint16_t kNewest = msg::kProtocolVersion;
constexpr std::uint16_t kOldest = kNewest > 1 ? kNewest - 1 : kNewest;
}  // namespace

Result<std::uint16_t> negotiate(const msg::Hello& peer) {
  const std::uint16_t newest = std::min(kNewest, peer.protocol_max);
  const std::uint16_t oldest = std::max(kOldest, peer.protocol_min);
  if (oldest <= newest) return newest;
  const auto range = [](std::uint16_t low, std::uint16_t high) {
    return std::to_string(low) + " to " + std::to_string(high);
  };
  return fail(ErrorCode::refused, peer.name + " speaks protocol " + range(peer.protocol_min, peer.protocol_max) +
                                      ", this server " + range(kOldest, kNewest) + ": update the " +
                                      (peer.protocol_max < kOldest ? "peer" : "server"));
}

}  // namespace weft::server
