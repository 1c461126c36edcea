#include "core/names.hpp"

#include <array>
#include <cstdio>
#include <string>

#include "core/utf8.hpp"

namespace weft {
namespace {

struct Range {
  char32_t first;
  char32_t last;
};
/// Lists what is no part of a word beyond ASCII (controls, spaces, punctuation, symbols, private use, emoji) by
/// Unicode's blocks, so that a name shows as it is read and two that look alike differ in more than what cannot be
/// seen.
constexpr std::array kNoLetters = {
    Range{0x80, 0xA9},        Range{0xAB, 0xB4},     Range{0xB6, 0xB9},     Range{0xBB, 0xBF},
    Range{0xD7, 0xD7},        Range{0xF7, 0xF7},     Range{0x61C, 0x61C},   Range{0x1680, 0x1680},
    Range{0x180E, 0x180E},    Range{0x2000, 0x206F}, Range{0x20A0, 0x20CF}, Range{0x2190, 0x2BFF},
    Range{0x2E00, 0x2E7F},    Range{0x3000, 0x3004}, Range{0x3008, 0x3020}, Range{0x3030, 0x3030},
    Range{0xE000, 0xF8FF},    Range{0xFE00, 0xFE1F}, Range{0xFE30, 0xFE6F}, Range{0xFEFF, 0xFEFF},
    Range{0xFF00, 0xFF0F},    Range{0xFF1A, 0xFF20}, Range{0xFFE0, 0xFFFF}, Range{0x1F000, 0x1FAFF},
    Range{0xE0000, 0x10FFFF},
};

bool is_letter_or_digit(char32_t c) {
  if (c < 0x80) return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
  for (const Range& range : kNoLetters) {
    if (c >= range.first && c <= range.last) return false;
  }
  return true;
}

/// Names a character as it can be shown: 'x', or U+00A0 for what would not be seen.
std::string shown(char32_t c, std::string_view bytes) {
  if (c > 0x20 && c < 0x7F) return "the character '" + std::string(bytes) + "'";
  std::array<char, 16> code{};
  std::snprintf(code.data(), code.size(), "U+%04X", static_cast<unsigned>(c));
  return std::string("the character ") + code.data();
}

}  // namespace

Result<void> check_name(std::string_view kind, std::string_view name) {
  const std::string which = std::string(kind) + " \"" + as_utf8(name, kLongestName) + "\"";
  const std::string rule = "; a name has " + std::string(kNameRule);
  if (name.empty() || name.size() > kLongestName) {
    return fail(ErrorCode::invalid, which + " has " + std::to_string(name.size()) + " bytes" + rule);
  }
  std::string_view rest = name;
  while (!rest.empty()) {
    const std::string_view before = rest;
    const std::optional<char32_t> c = take_code_point(rest);
    if (!c) return fail(ErrorCode::invalid, which + " is not UTF-8" + rule);
    const std::string_view bytes = before.substr(0, before.size() - rest.size());
    const bool is_mark = *c == '_' || *c == '.' || *c == '-';
    if (!is_letter_or_digit(*c) && !is_mark) {
      return fail(ErrorCode::invalid, which + " has " + shown(*c, bytes) + rule);
    }
    if (is_mark && before.size() == name.size()) {
      return fail(ErrorCode::invalid, which + " begins with '" + std::string(bytes) + "'" + rule);
    }
  }
  return {};
}

}  // namespace weft
