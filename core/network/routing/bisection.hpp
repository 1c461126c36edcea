#pragma once
#include <cstdint>
#include <vector>

#include "core/network/network.hpp"

/// Private to the routing folder.
namespace weft::routing {

/// Places by number, in the order of the network, with who they are joined with and a picture of where they lie.
struct Layout {
  std::vector<PlaceId> places;
  std::vector<std::uint32_t> first_arc;  ///< of each place in `arcs`, and their number
  std::vector<std::uint32_t> arcs;       ///< places to which one can drive from here
  std::vector<float> x;
  std::vector<float> y;
};

/// Cuts a stretch of places in two near the middle where few arcs cross: along each of four directions the places
/// are sorted into bins, arcs counted at each border between bins, and the best border taken (after the sweep of
/// Schild & Sommer, "On balanced separators in road networks" (2015), section 3, with counts in place of flows).
/// `part_of` holds one number for the places of this stretch and others elsewhere. Reorders [first, last) and
/// returns where the second part begins; both have at least one place. At least two places are given.
std::uint32_t bisect(const Layout& layout, std::vector<std::uint32_t>& order, std::uint32_t first, std::uint32_t last,
                     const std::vector<std::uint32_t>& part_of);

}  // namespace weft::routing
