#pragma once
#include <string>

#include "core/result.hpp"

namespace weft::process {

/// Returns the text of a program's settings file, none where `file` is empty. invalid: it cannot be read.
Result<std::string> read_settings(const std::string& file);

}  // namespace weft::process
