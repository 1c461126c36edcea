#pragma once
#include <array>
#include <cstdio>
#include <string>

namespace weft::agents {

/// Prints into a string, as printf does; what is longer than 511 bytes is cut.
template <class... Values>
std::string text(const char* format, Values... values) {
  std::array<char, 512> line{};
  std::snprintf(line.data(), line.size(), format, values...);
  return line.data();
}

}  // namespace weft::agents
