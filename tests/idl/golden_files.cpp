#include "tests/idl/golden_files.hpp"

#include <fstream>

#include "core/ids.hpp"

namespace weft::bus {

std::string hex_text(ByteView bytes) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  constexpr std::size_t kLine = 32;
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    if (i > 0 && i % kLine == 0) text += '\n';
    text += kDigits[bytes[i] >> 4U];
    text += kDigits[bytes[i] & 15U];
  }
  return text + '\n';
}

std::filesystem::path golden_path(const std::string& name) {
  return std::filesystem::path(WEFT_GOLDEN_DIR) / (name + ".hex");
}

Bytes read_golden(const std::string& name) {
  std::ifstream file(golden_path(name));
  std::string digits;
  for (std::string line; std::getline(file, line);) digits += line;
  Bytes bytes(digits.size() / 2);
  if (!parse_hex(digits, bytes.data(), bytes.size())) return {};
  return bytes;
}

}  // namespace weft::bus
