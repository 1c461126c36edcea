#pragma once
#include <string>
#include <string_view>
#include <variant>

#include "clients/evaluate/disturbances/study.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

/// A command line that is not to be run: help, or a mistake in one line.
struct NotRun {
  int exit_code = 2;
  std::string text;
};

std::variant<DisturbancesOptions, NotRun> parse(int argc, const char* const* argv);

/// "A..B", or one number. invalid: says what is wrong.
Result<Seeds> parse_seeds(std::string_view text);

}  // namespace weft::evaluate
