#pragma once
#include <optional>
#include <vector>

#include "agents/navigation/navigator.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// Returns the run as the navigator's method refines it before it is handed in; none: the method does not refine.
/// invalid: an amendment of what is not in the run; errors of a content.
Result<std::optional<std::vector<agents::Kept>>> refined_draft(const agents::Navigator& navigator,
                                                               const std::vector<agents::Kept>& draft);

}  // namespace weft::evaluate::floor
