#pragma once
#include "agents/methods/ceiling/content.hpp"

namespace weft::agents {

/// Holds where two contents together put the ceiling that both show.
struct SharedCeiling {
  double ceiling_m = 0.0;
  double sigma_m = 0.0;
  double apart_sigmas = 0.0;  ///< their own heights against each other
};
SharedCeiling shared_ceiling(const CeilingContent& a, const CeilingContent& b);

/// Returns the content as if it had been made with the ceiling at that height: directions stay, distances are scaled.
CeilingContent at_ceiling(const CeilingContent& content, double ceiling_m);

}  // namespace weft::agents
