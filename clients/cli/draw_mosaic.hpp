#pragma once
#include <string>

#include "clients/cli/layout.hpp"
#include "clients/cli/mosaic.hpp"
#include "core/network/window.hpp"
#include "core/result.hpp"

namespace weft::cli {

/// Draws a mosaic as people look at it, with the labels of the places below it, a title ("Weft mosaic", with the
/// revision behind it), a line on what it is, and a scale in metres. The layout is the one that the mosaic was laid
/// by. invalid: the file's name ends neither in .png nor in .svg. exhausted: the file cannot be written.
Result<void> draw_mosaic(const Mosaic& mosaic, const Window& network, const Layout& layout, const std::string& title,
                         const std::string& detail, const std::string& file);

}  // namespace weft::cli
