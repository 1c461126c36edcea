#pragma once
#include <string>
#include <vector>

#include "agents/bodies/sim/site.hpp"

/// The same site on another floor, under other light, and worn: what a study teaches on and repeats on. Pure; each
/// says only what the keys of a site file can say too (docs/simulation.md: [floor] and [change]).
namespace weft::agents::sim {

/// Floors that differ in kind, each a `floor.material`.
const std::vector<std::string>& floor_kinds();
/// `kind`: any material, those of floor_kinds() among them. invalid: names those there are.
Result<Site> on_floor(Site site, const std::string& kind);

/// The first is "same", which changes nothing.
const std::vector<std::string>& light_names();
/// invalid: no such light (names those there are).
Result<Site> under_light(Site site, const std::string& name);

/// The first is "same", which changes nothing.
const std::vector<std::string>& wear_names();
/// invalid: no such wear (names those there are).
Result<Site> with_wear(Site site, const std::string& name);

}  // namespace weft::agents::sim
