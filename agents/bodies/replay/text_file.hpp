#pragma once
#include <filesystem>
#include <string>

#include "core/result.hpp"

namespace weft::agents::replay {

/// Returns the text of a file of a recording. not_found: names it, and how recordings are laid out.
Result<std::string> read_text(const std::filesystem::path& path);

}  // namespace weft::agents::replay
