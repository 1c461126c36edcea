#pragma once
#include "core/time.hpp"

namespace weft::server {

/// Holds both clocks at one moment: `steady` decides, `wall` is written down.
struct Now {
  SteadyTime steady{};
  WallTime wall{};
};

}  // namespace weft::server
