#pragma once
#include <vector>

#include "clients/evaluate/invocation.hpp"

namespace weft::evaluate {

/// Returns what weft-evaluate makes of these words of a command line.
inline Parsed parsed(std::vector<const char*> words) {
  words.insert(words.begin(), "weft-evaluate");
  return parse(static_cast<int>(words.size()), words.data());
}

}  // namespace weft::evaluate
