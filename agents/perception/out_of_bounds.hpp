#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/result.hpp"

namespace weft::agents {

/// Says whether a setting may be as low as its low bound.
enum class Low : std::uint8_t { open, closed };

/// Collects what is out of bounds: "<room>: <part>.<name> is 7; it must be in (0, 2]".
class OutOfBounds {
 public:
  explicit OutOfBounds(std::string room) : room_(std::move(room)) {}
  auto section(const std::string& part) {
    return [this, prefix = part.empty() ? part : part + "."](const char* name, const auto& value, Low kind,
                                                             double low, double high) {
      const auto number = static_cast<double>(value);
      if (number <= high && (number > low || (kind == Low::closed && number == low))) return;
      issues.push_back({ErrorCode::invalid, room_ + ": " + prefix + name + " is " + std::to_string(number) +
                                                "; it must be in " + (kind == Low::closed ? "[" : "(") +
                                                std::to_string(low) + ", " + std::to_string(high) + "]"});
    };
  }
  std::vector<Error> issues;

 private:
  std::string room_;
};

}  // namespace weft::agents
