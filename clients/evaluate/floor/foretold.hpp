#pragma once
#include <optional>
#include <string>
#include <vector>

#include "agents/methods/floor/floor.hpp"
#include "agents/navigation/config.hpp"
#include "agents/navigation/teach_report.hpp"
#include "clients/evaluate/floor/drive.hpp"
#include "clients/evaluate/floor/scenario.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// Names the light or wear of the simulated body that a condition is about: teaching foretells what another robot
/// finds under it, and the study holds that against what it really finds.
const std::string& light_of(agents::Floor::Condition condition);

/// Holds for one place what teaching foretold and what another robot found.
struct Compared {
  double at_m = 0.0;
  bool foretold = false;
  bool found = false;
};

/// Leads another robot along the same line by a clumsy hand, on another day, in the condition's light, and relates
/// its view nearest to each place to it, with a guess off as in localising: it must agree with the truth within
/// `config`'s agree_m and agree_rad. Places with no view within half a metre are left out. None: stopped.
Result<std::optional<std::vector<Compared>>> compare(const Scenario& scenario, agents::Floor::Condition condition,
                                                     const Taught& taught, const agents::StitchConfig& config);

/// Tells how well the two agree: of all places, and of each metre by itself.
struct Agreement {
  std::size_t places = 0;
  double foretold = 0.0;     ///< share
  double found = 0.0;        ///< share
  double metre_apart = 0.0;  ///< mean difference of the two shares of a metre
};
Agreement agreement_of(const std::vector<Compared>& compared);

}  // namespace weft::evaluate::floor
