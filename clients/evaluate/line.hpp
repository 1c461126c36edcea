#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "agents/bodies/body.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

/// Reads a teach line (docs/simulation.md): "x y" a row, metres in the site's frame, '#' begins a comment. invalid:
/// names file and row.
Result<std::vector<agents::SitePoint>> parse_line(std::string_view text, const std::string& file);

/// Returns the line's beginning, this long. invalid: it is shorter.
Result<std::vector<agents::SitePoint>> first_metres(const std::vector<agents::SitePoint>& line, double metres,
                                                    const std::string& file);

}  // namespace weft::evaluate
