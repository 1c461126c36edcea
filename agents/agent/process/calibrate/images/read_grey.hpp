#pragma once
#include <optional>
#include <string>

#include "agents/perception/view.hpp"

namespace weft::agents {

/// None: the file cannot be read, is no image, or is damaged.
std::optional<Image> read_grey(const std::string& file);

}  // namespace weft::agents
