#pragma once
#include <array>
#include <charconv>
#include <string>

namespace weft {

/// Returns the shortest text that reads back as the same bits.
inline std::string number_text(double value) {
  std::array<char, 32> text{};
  const auto [end, problem] = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), problem == std::errc() ? end : text.data()};
}

}  // namespace weft
