#pragma once
#include <algorithm>
#include <string>

#include "core/protocol/messages.hpp"
#include "core/result.hpp"

namespace weft::msg {

/// Holds the protocol versions that a program speaks, both ends included.
struct VersionRange {
  std::uint16_t min = kProtocolVersion;
  std::uint16_t max = kProtocolVersion;
};

/// Returns the highest version that both speak. newer: the peer begins above `own`; stale: it ends below. The message
/// says who speaks what and which of the two is to be updated.
inline Result<std::uint16_t> negotiate(const VersionRange& own, const Hello& hello) {
  if (hello.protocol_min <= own.max && own.min <= hello.protocol_max) return std::min(own.max, hello.protocol_max);
  const auto range = [](std::uint16_t min, std::uint16_t max) {
    return min == max ? std::to_string(min) : std::to_string(min) + " to " + std::to_string(max);
  };
  const bool is_newer = hello.protocol_min > own.max;
  return fail(is_newer ? ErrorCode::newer : ErrorCode::stale,
              "'" + hello.name + "' (" + hello.software + ") speaks protocol " +
                  range(hello.protocol_min, hello.protocol_max) + ", this side " + range(own.min, own.max) +
                  ": update " + (is_newer ? "this side" : "'" + hello.name + "'"));
}

}  // namespace weft::msg
