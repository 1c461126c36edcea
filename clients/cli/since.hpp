#pragma once
#include <optional>
#include <string>

#include "core/result.hpp"
#include "core/time.hpp"

namespace weft::cli {

/// Names a moment of the past as an operator does.
struct Since {
  std::optional<WallTime> at;  ///< none: so long ago
  Duration ago{};

  WallTime when(WallTime now) const { return at.value_or(now - ago); }
};

/// Reads "90s", "10min", "2h" or "1d", or a time in UTC as logs have it: 2026-03-01T09:30:05Z, with or without
/// milliseconds. invalid: it is none of them; says what is.
Result<Since> parse_since(const std::string& text);

}  // namespace weft::cli
