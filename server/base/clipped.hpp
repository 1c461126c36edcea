#pragma once
#include <cstddef>
#include <string>

namespace weft::server {

inline constexpr std::size_t kLongestText = 2000;

/// Cuts text for people to what a message may carry.
inline std::string clipped(std::string text) {
  if (text.size() > kLongestText) text.resize(kLongestText);
  return text;
}

}  // namespace weft::server
