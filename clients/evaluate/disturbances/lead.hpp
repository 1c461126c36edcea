#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

#include "agents/bodies/body.hpp"
#include "agents/bodies/sim/site.hpp"
#include "clients/evaluate/disturbances/score.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

/// Describes two runs: one robot is led along the line and remembers places; another one, built a little differently,
/// is led along it on another day and looks for them, told nothing but its view. Both see with the method `floor`.
struct LeadTask {
  agents::sim::Site site;
  std::vector<agents::SitePoint> line;
  std::uint64_t seed = 1;
  std::filesystem::path scratch;        ///< a file for the truth; made and removed
  std::function<bool()> asked_to_stop;  ///< asked at every sample
};

/// Leads both robots and scores their runs. None: stopped in the middle. Errors are the body's and the method's own:
/// a site that cannot be driven along the line, a calibration out of bounds.
Result<std::optional<Score>> measure(const LeadTask& task);

}  // namespace weft::evaluate
