#pragma once
#include <functional>
#include <string>
#include <vector>

#include "agents/bodies/sim/site.hpp"

namespace weft::evaluate::bearing {

/// Describes a day on which a taught way is driven once.
struct Day {
  std::string about;
  std::function<void(agents::sim::Site&)> as;  ///< what the site is like
};

/// Lists days one after the other, from the day after teaching on.
struct Days {
  std::string name;
  std::string about;  ///< for tables
  std::vector<Day> days;
};
const std::vector<Days>& all_days();

}  // namespace weft::evaluate::bearing
