#pragma once
#include <optional>

#include "agents/methods/method.hpp"
#include "core/network/window.hpp"

namespace weft::agents {

/// Expresses what is believed by the nearest place that stays in the window `after`; none: none does. `known`: a map
/// of the method's own. Over the places of others a pose would become a distance.
std::optional<Estimate> on_what_stays(const Estimate& believed, const Window& known, const Window& after);

}  // namespace weft::agents
