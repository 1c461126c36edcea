#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "agents/methods/method.hpp"
#include "core/bytes.hpp"

namespace weft::server {

/// Signs contents of one method and format; none when a content cannot be read or gives no signature.
using Signer = std::function<std::optional<agents::Signature>(ByteView content)>;
/// Maps method and content format to their signer. The set is chosen where the server is put together.
using Signers = std::map<std::pair<std::string, std::uint32_t>, Signer>;

}  // namespace weft::server
