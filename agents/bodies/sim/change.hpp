#pragma once
#include <cstdint>

/// What is no longer as it was when the robots were taught: [change] of a site file.
namespace weft::agents::sim {

/// Nothing of it by default.
struct Change {
  double light = 1.0;  ///< factor on all light; the camera's exposure stays

  bool operator==(const Change&) const = default;
};

}  // namespace weft::agents::sim
