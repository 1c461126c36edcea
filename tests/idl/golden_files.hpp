#pragma once
#include <filesystem>
#include <string>

#include "core/bytes.hpp"

namespace weft::bus {

std::string hex_text(ByteView bytes);  ///< lines of 32 bytes
/// Reads a golden message; empty when there is no such file.
Bytes read_golden(const std::string& name);
std::filesystem::path golden_path(const std::string& name);

}  // namespace weft::bus
