#pragma once
#include <string>

namespace weft {

/// Holds a quantity that was measured as a by-product: what driving shows of a camera's mount, how many places will
/// be found again in half the light.
struct Diagnostic {
  std::string name;    ///< ends with its unit, if it has one: "mount_pitch_rad"
  double value = 0.0;  ///< in that unit
  double sigma = 0.0;  ///< one sigma of `value`; 0: not stated
  double bound = 0.0;  ///< from where on a person is to look at it; 0: nowhere
  bool operator==(const Diagnostic&) const = default;
};

}  // namespace weft
