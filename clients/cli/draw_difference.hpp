#pragma once
#include <string>

#include "core/network/window.hpp"
#include "core/result.hpp"

namespace weft::cli {

/// Draws two revisions as one network: what both have in grey, what came in one colour, what went in another, dashed.
/// Labels of places that are not there are left out. `note` ends the caption. Errors as of `draw`.
Result<void> draw_difference(const Window& from, const Window& to, const std::string& note, const std::string& file);

}  // namespace weft::cli
