#pragma once
#include <filesystem>

#include "images/picture.hpp"

namespace weft::images {

/// Reads a file as `decode` has it. not_found: there is no such file; unavailable: it cannot be read; exhausted: it
/// has more than a gigabyte.
Result<Picture> read(const std::filesystem::path& file, Shades shades);

}  // namespace weft::images
