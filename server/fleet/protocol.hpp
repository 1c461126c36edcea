#pragma once
#include <cstdint>

#include "core/protocol/messages.hpp"
#include "core/result.hpp"

namespace weft::server {

/// The newest protocol version that we and the peer both speak. refused: there is none; says who has to be updated.
Result<std::uint16_t> negotiate(const msg::Hello& peer);

}  // namespace weft::server
