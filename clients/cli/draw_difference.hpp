#pragma once
#include <string>

#include "core/network/window.hpp"
#include "core/result.hpp"

namespace weft::cli {

/// Draws two revisions as one network: what both have in grey, what came in one colour, what went in another, dashed.
/// Errors as of `draw`.
Result<void> draw_difference(const Window& from, const Window& to, const std::string& file);

}  // namespace weft::cli
