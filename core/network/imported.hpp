#pragma once

namespace weft {

/// Marks places that come from a file, as their method. No robot has it, so nobody drives there; they can be drawn,
/// exported and compared.
inline constexpr const char* kImportedMethod = "imported";

}  // namespace weft
