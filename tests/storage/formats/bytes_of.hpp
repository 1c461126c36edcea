#pragma once
#include <string>

#include "core/bytes.hpp"

namespace weft::formats {

inline Bytes bytes_of(const std::string& text) {
  return {text.begin(), text.end()};
}

}  // namespace weft::formats
