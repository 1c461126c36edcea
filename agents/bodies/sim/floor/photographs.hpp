#pragma once
#include <functional>
#include <memory>
#include <string>

#include "agents/bodies/sim/floor/source.hpp"
#include "agents/bodies/sim/site.hpp"

namespace weft::agents::sim {

/// Makes a floor quilted from seeded crops and turns of the photographs (png, jpg) in a folder. Millimetres a pixel
/// come from `floors.toml` in it ([name] file, mm_per_pixel) or from FILE.toml beside a picture (mm_per_pixel);
/// without either 0.7 is assumed and said through `warn`. With several photographs, each covers regions of some
/// metres. not_found: the folder, a listed file, or the one that setup.photograph names; corrupt: a picture that
/// cannot be read; invalid: a sidecar's key, by file and line. Each names the file. `light_warmth`, -1 (blue) to 1
/// (red), is the colour of all light: red weighs 1 + light_warmth times as much in the grey and blue 1 - light_warmth
/// times, such that grey keeps its level.
Result<std::shared_ptr<const FloorSource>> make_photographed_floor(
    const FloorSetup& setup, const std::string& folder, const std::function<void(const std::string&)>& warn,
    double light_warmth = 0.0);

}  // namespace weft::agents::sim
