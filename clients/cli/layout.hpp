#pragma once
#include <map>
#include <vector>

#include "core/geometry/pose2.hpp"
#include "core/network/window.hpp"

namespace weft::cli {

/// Lays places out on one sheet, for people: the network itself has no common frame.
struct Layout {
  std::map<PlaceId, Pose2> drawing_from_place;
  std::size_t islands = 0;                ///< parts that no edge joins; set side by side
  std::map<PlaceId, std::size_t> island;  ///< which part each place is in
};

/// Composes relations outwards from the largest experience's first place, along experiences first and over stitches
/// where they begin, then lets every place give way to its neighbours until the sheet is at ease.
Layout lay_out(const Window& network);

}  // namespace weft::cli
