#include "core/utf8.hpp"

#include <cstdint>

namespace weft {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

/// Returns how many bytes a character has by its first one; 0: no character begins with it.
std::size_t length_by(std::uint8_t first) {
  if (first < 0x80) return 1;
  if (first < 0xC2) return 0;  // a byte from within a character, or one that a shorter character stands for
  if (first < 0xE0) return 2;
  if (first < 0xF0) return 3;
  return first < 0xF5 ? 4 : 0;
}

bool is_valid(char32_t code, std::size_t length) {
  constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
  return code >= least[length] && code <= 0x10FFFF && (code < 0xD800 || code > 0xDFFF);
}

}  // namespace

std::optional<char32_t> take_code_point(std::string_view& text) {
  if (text.empty()) return std::nullopt;
  const auto first = static_cast<std::uint8_t>(text.front());
  const std::size_t length = length_by(first);
  if (length == 0 || length > text.size()) return std::nullopt;
  char32_t code = length == 1 ? first : first & (0x7FU >> length);
  for (std::size_t i = 1; i < length; ++i) {
    const auto byte = static_cast<std::uint8_t>(text[i]);
    if ((byte & 0xC0U) != 0x80) return std::nullopt;
    code = code << 6U | (byte & 0x3FU);
  }
  if (!is_valid(code, length)) return std::nullopt;
  text.remove_prefix(length);
  return code;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    if (!take_code_point(text)) return false;
  }
  return true;
}

std::string as_utf8(std::string_view text, std::size_t most) {
  std::string clean;
  while (!text.empty()) {
    const std::string_view before = text;
    const bool is_good = take_code_point(text).has_value();
    if (!is_good) text.remove_prefix(1);
    const std::string_view next = is_good ? before.substr(0, before.size() - text.size()) : kReplacement;
    if (clean.size() + next.size() > most) break;
    clean += next;
  }
  return clean;
}

}  // namespace weft
