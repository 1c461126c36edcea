#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "clients/evaluate/bearing/rows.hpp"
#include "clients/evaluate/bearing/shown.hpp"
#include "core/result.hpp"

namespace weft::evaluate::bearing {

/// By trial, of the first seed.
using AllShown = std::map<std::string, Shown>;

/// paths.png, first-loop.png, loops.png and ablation.png in a folder; what cannot be drawn for want of runs is left
/// out. Gives their names. unavailable: names the file.
Result<std::vector<std::string>> draw_figures(const AllShown& shown, const Rows& rows, Seeds seeds,
                                              const std::filesystem::path& folder);

}  // namespace weft::evaluate::bearing
