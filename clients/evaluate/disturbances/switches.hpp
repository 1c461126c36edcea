#pragma once
#include <string>
#include <vector>

#include "agents/bodies/sim/site.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

/// Names one set of disturbances to measure.
struct Variant {
  enum class Kind { none, all, without, with, only };
  Kind kind = Kind::all;
  std::string disturbance;  ///< for `without`, `with` and `only`
  agents::sim::Disturbances disturbances;
};

std::string name_of(const Variant& variant);

/// Returns the disturbances that can be switched by themselves, in the order of docs/simulation.md; those that sites
/// have off unless they say otherwise come last.
std::vector<std::string> disturbance_names();

/// Returns: none, the site as it is, then for each disturbance the site without it and with it alone. Those that are
/// off have a size of their own here, which their names say: the site with it as well, and with it alone.
std::vector<Variant> variants_of(const agents::sim::Disturbances& site);

/// Returns those of these names, in the order of `all`; a disturbance's name means all that are about it. No names:
/// all. invalid: says which name is none, and what there is.
Result<std::vector<Variant>> named(const std::vector<Variant>& all, const std::vector<std::string>& names);

}  // namespace weft::evaluate
