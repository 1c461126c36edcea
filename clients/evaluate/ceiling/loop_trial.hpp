#pragma once
#include <vector>

#include "clients/evaluate/ceiling/score.hpp"
#include "clients/evaluate/ceiling/way.hpp"

namespace weft::evaluate::ceiling {

/// Scores a taught way as a map: where its places are by odometry, as the method has refined them, and by the
/// homographies of the published mosaic, each against the truth after the rotation and translation with the least
/// squares; how far odometry drifts to the way's end; how many stitches are wrong.
Measured measure_loop(const Way& way);

/// Returns where the places of an experience are in the frame of the first, by its chain alone.
std::vector<Pose2> chained(const Experience& experience);

}  // namespace weft::evaluate::ceiling
