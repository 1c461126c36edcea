#pragma once
#include <string>
#include <vector>

#include "clients/cli/commands.hpp"
#include "clients/cli/layout.hpp"

namespace weft::cli {

/// Holds the network where it is to be drawn or written: as laid out, or in the site's frame.
struct Laid {
  Window network;
  Layout layout;
  std::string caption;
};

/// Draws it, with robots if that is wanted. `robots` are all the server knows.
Exit run_map_draw(Session& session, Laid laid, const std::vector<msg::RobotRow>& robots, const Invocation& invocation,
                  const Output& output);

/// Draws the patches of its places, laid together. refused: no place has one.
Exit run_map_mosaic(Session& session, const Laid& laid, const Invocation& invocation, const Output& output);

/// Writes the clouds of its places, laid together, or draws them as seen from above. refused: no place has one.
Exit run_map_clouds(Session& session, const Laid& laid, const Invocation& invocation, const Output& output);

/// Says that the file is written: a line, or a document with the members of `more` too.
void say_written(const Window& network, const std::string& caption, const nlohmann::json& more,
                 const Invocation& invocation, const Output& output);

}  // namespace weft::cli
