#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "clients/evaluate/disturbances/summary.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

/// A PNG of four panels: speed error, drift, error of fixes, fixes a view. Each has a line a disturbance, with the
/// site without it (or, where sites have it off, with it) and with it alone, beside none and all. `about`: one line
/// below the title.
Result<void> draw_disturbances(const Rows& rows, const std::vector<std::string>& disturbances, Seeds seeds,
                               const std::string& about, const std::filesystem::path& file);

}  // namespace weft::evaluate
