#pragma once
#include <cstdint>
#include <vector>

#include "agents/perception/heading_vote.hpp"
#include "agents/perception/upright_features.hpp"

namespace weft::agents {

/// Returns how many of the pairs `same` are at heights, within `within_px` pixels, that one scene allows: the second
/// camera may be pitched and rolled against the first one and nearer to everything by one share. Most pairs are when
/// the two views show one scene, and a few by chance when the scenes only look alike. Returns 0 for fewer than eight
/// pairs.
///
/// With azimuth u and elevation e (both the mean of the two views) pitch p, roll r and share s raise a feature by
/// (1 + e^2) (p cos u + r sin u) + s e, right to the second order. A view that is turned against another one by a
/// camera whose mount is pitched shows a roll.
std::uint32_t scene_inliers(const std::vector<UprightFeature>& a, const std::vector<UprightFeature>& b,
                            const std::vector<Match>& same, double focal_px, double within_px);

}  // namespace weft::agents
