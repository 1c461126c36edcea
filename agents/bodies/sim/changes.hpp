#pragma once
#include <string>
#include <vector>

#include "agents/bodies/sim/site.hpp"

/// Puts the same site on another floor, under other light, and wears it: what a study teaches on and repeats on.
/// Pure; each function says only what the keys of a site file can say too (docs/simulation.md: [floor] and [change]).
namespace weft::agents::sim {

/// Returns floors that differ in kind, each a `floor.material`.
const std::vector<std::string>& floor_kinds();
/// Returns the site on a floor of any material, those of floor_kinds() among them. invalid: none such (names them).
Result<Site> on_floor(Site site, const std::string& kind);

/// Returns the names of lights; the first is "same", which changes nothing.
const std::vector<std::string>& light_names();
/// Returns the site under that light. invalid: no such light (names those there are), or "glare" without a lamp.
Result<Site> under_light(Site site, const std::string& name);

/// Returns the names of wears; the first is "same", which changes nothing.
const std::vector<std::string>& wear_names();
/// Returns the site so worn. invalid: no such wear (names those there are).
Result<Site> with_wear(Site site, const std::string& name);

}  // namespace weft::agents::sim
