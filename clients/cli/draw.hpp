#pragma once
#include <optional>
#include <string>
#include <vector>

#include "clients/cli/json.hpp"
#include "clients/cli/layout.hpp"
#include "clients/cli/plan_layer.hpp"
#include "core/network/window.hpp"
#include "core/protocol/messages.hpp"
#include "core/result.hpp"

namespace weft::cli {

/// Draws the network as people look at it: experiences in their colours, stitches, labels, robots, a scale in metres.
/// invalid: the file's name ends neither in .png nor in .svg; unavailable: it cannot be written.
Result<void> draw(const Window& network, const std::vector<msg::RobotRow>& robots, const std::string& file);

/// The same as it is laid out, upon a floor plan if there is one, in whose frame the layout is then.
/// invalid: also a floor plan that is too large to draw.
Result<void> draw(const Window& network, const Layout& layout, const std::optional<Ground>& ground,
                  const std::vector<msg::RobotRow>& robots, const std::string& file);

}  // namespace weft::cli
