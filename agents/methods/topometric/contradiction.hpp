#pragma once
#include <cstddef>

#include "agents/methods/topometric/content.hpp"
#include "core/geometry/pose3.hpp"

namespace weft::agents {

/// Counts the parts of a place's newest view, 4.6 degrees wide and high, in which another place's cloud shows
/// something above the floor that stands behind nothing.
struct ExpectedInView {
  std::size_t seen = 0;     ///< the view shows something about as far away,
  std::size_t through = 0;  ///< or only what is farther off: something has come or gone,
  std::size_t blank = 0;    ///< or nothing at all, as of a plain wall
};

/// Looks for what b's cloud shows from 0.8 m to `within_m` from a's newest camera in what that showed.
ExpectedInView expected_in_view(const TopometricContent& a, const PlaceCloud& b, const Pose3& a_from_b,
                                double within_m);

}  // namespace weft::agents
