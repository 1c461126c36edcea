#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "agents/bodies/sim/floor/source.hpp"
#include "agents/bodies/sim/site.hpp"

namespace weft::agents::sim {

/// Makes the floor that a site's [floor] and [change] describe; with `photographs`, a folder of them, in place of a
/// material. Errors as make_procedural_floor and make_photographed_floor.
Result<std::shared_ptr<const FloorSource>> make_site_floor(const Site& site,
                                                           const std::optional<std::string>& photographs,
                                                           const std::function<void(const std::string&)>& warn);

}  // namespace weft::agents::sim
