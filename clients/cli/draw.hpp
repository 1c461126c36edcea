#pragma once
#include <string>

#include "clients/cli/picture.hpp"
#include "core/result.hpp"

namespace weft::cli {

/// Draws the network as people look at it: runs in their colours, stitches, labels, robots, a scale in metres and a
/// legend; upon a floor plan if there is one, in whose frame the layout is then.
/// invalid: the file's name ends neither in .png nor in .svg, or the floor plan is too large to draw. exhausted: the
/// file cannot be written.
Result<void> draw(const Subject& subject, const std::string& file);

}  // namespace weft::cli
