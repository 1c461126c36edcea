#pragma once
#include <cstdint>
#include <filesystem>

#include "core/ids.hpp"
#include "core/random.hpp"
#include "core/result.hpp"

namespace weft::server {

/// Loads the server's own id: drawn at its first start, kept beside the store as DIR/identity (32 hex digits).
/// unavailable: the directory cannot be made or written. corrupt: the file holds something else.
Result<PeerId> load_identity(const std::filesystem::path& directory);

/// Returns a generator seeded by the machine; differs at every call.
Random random_from_machine();

}  // namespace weft::server
