#pragma once
#include <string>

#include "agents/bodies/sim/hall/textures.hpp"
#include "core/result.hpp"

namespace weft::agents::sim {

/// Reads photographs in place of what is drawn: FOLDER/STUFF/*.png or .jpg, a folder for each stuff that has some
/// (load, sign, wall, ceiling, steel, pallet, vehicle, clothing, floor). A load's or a sign's picture fills what it
/// is on, the others show 2.56 m. Brought to one mean: how bright things are is the site's. not_found: no such
/// folder, or nothing in it; invalid: a folder of no stuff (names those there are); corrupt: a picture, by name.
Result<Photographed> read_hall_photographs(const std::string& folder);

}  // namespace weft::agents::sim
