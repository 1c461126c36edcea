#pragma once
#include <optional>
#include <string>

#include "agents/perception/view.hpp"

namespace weft::agents {

/// Reads an image in grey. None: the file cannot be read, is no image, or is damaged.
std::optional<Image> read_grey(const std::string& file);

}  // namespace weft::agents
