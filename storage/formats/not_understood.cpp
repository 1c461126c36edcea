#include "storage/formats/not_understood.hpp"

#include <algorithm>

namespace weft::formats {

std::string to_string(const NotUnderstood& part, std::string_view file) {
  return std::string(file) + ":" + std::to_string(part.line) + ": " + part.what +
         (part.count == 1 ? ", once" : ", " + std::to_string(part.count) + " times");
}

void Leftovers::note(std::string_view what, std::size_t line) {
  const auto known =
      std::find_if(parts_.begin(), parts_.end(), [what](const NotUnderstood& part) { return part.what == what; });
  if (known == parts_.end()) {
    parts_.push_back({.what = std::string(what), .line = line, .count = 1});
  } else {
    ++known->count;
  }
}

}  // namespace weft::formats
