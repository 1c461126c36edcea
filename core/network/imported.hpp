#pragma once

namespace weft {

/// The method of places that come from a file. No robot has it, so nobody drives there; they can be drawn, exported
/// and compared.
inline constexpr const char* kImportedMethod = "imported";

}  // namespace weft
