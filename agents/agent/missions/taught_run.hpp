#pragma once
#include <cstddef>
#include <set>
#include <string>
#include <vector>

#include "agents/agent/experience_ids.hpp"
#include "agents/navigation/navigator.hpp"
#include "core/ids.hpp"
#include "core/network/network.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Describes a run that is taught: an experience for each method, and what has been kept of it.
struct TaughtRun {
  ExperienceId experience;           ///< of the first method
  std::vector<ExperienceId> others;  ///< of the methods beside it
  std::string name;
  std::size_t kept = 0;                    ///< places of all its experiences
  std::set<PlaceId> joined = {};           ///< of these, to places of other runs or far back in the same one
  std::set<ExperienceId> told_apart = {};  ///< runs that it looks like and is not joined to

  /// Returns whether the edge joins the run to something. One between places that two cameras of this robot see does
  /// not, nor one that nobody can drive.
  bool joins(const Edge& edge) const;
  void count(const Kept& place);
  /// Counts places that edges join which come later than they.
  void count(const std::vector<Edge>& edges);
};

/// Draws the experiences of a run with these methods. refused: with the name of a method added, the name is too long.
Result<TaughtRun> new_run(const std::string& name, const std::vector<std::string>& methods, ExperienceIds& ids);

/// Returns the name of the experience of a method beside the first one; none of a run without a name.
std::string name_of_other(const std::string& name, const std::string& method);

/// Says how much was taught and whether it is joined to anything, for whoever has led the robot: that person is still
/// there, and can lead it on to where it meets what was taught before.
std::string summary(const TaughtRun& run);

}  // namespace weft::agents
