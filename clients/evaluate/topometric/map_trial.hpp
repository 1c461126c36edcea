#pragma once
#include <optional>
#include <vector>

#include "clients/evaluate/topometric/scenes.hpp"
#include "clients/evaluate/topometric/score.hpp"
#include "clients/evaluate/topometric/taught.hpp"

namespace weft::evaluate::topometric {

/// Teaches the robot r1 the line of a site, on the first day. None: stopped.
Result<std::optional<Taught>> teach_line(const agents::sim::Site& site, const std::vector<agents::SitePoint>& line,
                                         const Driven& driven);

/// Returns level11 as it is taught: with two blackouts, and somebody who walks in the lobby.
agents::sim::Site level11_as_taught(const Scenes& scenes, const Driven& driven);

/// Judges a taught map of level11: what odometry has said, how edges lie after contents were compared, charts' grids
/// against the site; then has another robot taught some of the same way on the next day, and judges how thick walls
/// look in charts of both. None: stopped.
Result<std::optional<Measured>> measure_map(const Scenes& scenes, const Driven& driven, const Taught& taught);

/// Adds what a drive says of odometry: open_m, raw_m, their shares, blind_percent, wrong_seen_percent.
void add_odometry(const Moments& moments, Score& score);

}  // namespace weft::evaluate::topometric
