#pragma once
#include <string>
#include <vector>

#include "agents/bodies/sim/site.hpp"

namespace weft::evaluate {

/// One set of disturbances to measure.
struct Variant {
  enum class Kind { none, all, without, only };
  Kind kind = Kind::all;
  std::string disturbance;  ///< for `without` and `only`
  agents::sim::Disturbances disturbances;
};

std::string name_of(const Variant& variant);

/// The disturbances that can be switched by themselves, in the order of docs/simulation.md.
std::vector<std::string> disturbance_names();

/// None, the site as it is, then each disturbance: the site without it, and with it alone.
std::vector<Variant> variants_of(const agents::sim::Disturbances& site);

}  // namespace weft::evaluate
