#pragma once
#include <array>

#include "clients/cli/sheet.hpp"
#include "core/ids.hpp"

namespace weft::cli {

/// Holds the colours that runs are drawn in: told apart also by most people who see colours differently (any two
/// differ by 0.12 or more in OKLab), and from stitches, grey and white.
inline constexpr std::array<Colour, 20> kRunColours = {
    {{0.00, 0.45, 0.70}, {0.84, 0.37, 0.00}, {0.00, 0.62, 0.45}, {0.00, 0.00, 0.88}, {0.00, 0.38, 0.00},
     {0.00, 0.69, 1.00}, {0.00, 0.81, 0.00}, {0.38, 0.31, 1.00}, {0.63, 0.44, 0.69}, {0.69, 0.13, 0.25},
     {0.81, 0.00, 0.88}, {1.00, 0.31, 0.56}, {1.00, 0.44, 0.94}, {0.94, 0.56, 0.50}, {0.56, 0.44, 0.00},
     {0.63, 0.63, 0.31}, {0.44, 0.19, 0.25}, {0.75, 0.06, 0.56}, {0.13, 0.25, 0.63}, {0.56, 0.00, 0.81}}};

/// Returns the colour of a run, by its id alone: the same in every picture, whatever else is drawn. Two runs of a map
/// may share a colour; their names tell them apart.
const Colour& run_colour(ExperienceId run);

}  // namespace weft::cli
