#pragma once
#include <functional>
#include <string>
#include <vector>

#include "agents/bodies/sim/site.hpp"
#include "clients/evaluate/bearing/relocalise/aisles.hpp"

namespace weft::evaluate::bearing {

/// Describes a kind of trials: what the aisles hold, and where a robot is put down. All aisles but one are taught.
struct LookAlikes {
  enum class Where : std::uint8_t {
    taught,      ///< on the line of a taught aisle
    not_taught,  ///< on the line of the one aisle that nobody taught, which the seed chooses
    anywhere     ///< in all of the hall
  };
  std::string name;
  std::string about;  ///< for tables and pictures
  Loads loads = Loads::other;
  Where where = Where::taught;
  double found_share = 0.0;  ///< of a light's trials, that is promised to find itself; 0: often no answer is right
  bool is_judged = true;     ///< false: what the camera sees tells no answer from another
};
const std::vector<LookAlikes>& look_alikes();

/// Returns "other-loads", "one-side" or "same-loads".
const char* name_of(Loads loads);

/// Changes the hall to that of the day when a robot is put down.
struct OtherLight {
  std::string name;
  std::function<void(agents::sim::Site&)> as;
};
const std::vector<OtherLight>& other_lights();

}  // namespace weft::evaluate::bearing
