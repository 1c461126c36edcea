#pragma once
#include <vector>

#include "agents/bodies/sim/site.hpp"
#include "agents/perception/camera_model.hpp"
#include "clients/evaluate/ceiling/height_watch.hpp"
#include "clients/evaluate/floor/trace.hpp"

namespace weft::evaluate::ceiling {

/// Sums up how far heights are off.
struct HeightErrors {
  std::vector<double> hanging_m;  ///< |error| of what hangs below the ceiling, as if it were 5 m above the camera
  std::size_t all = 0;
  std::size_t beyond = 0;  ///< of all, off by more than 3 of the sigmas that the method states
};

/// Judges heights by the simulation's truth: by what still stands in the site where rays from the robot's true pose
/// meet it. A corner lies at the rim of things: of the heights within 3 pixels of it the one counts that is nearest
/// to what is said of it. The camera is the one that agents are told: its error moves a ray by less than that.
HeightErrors judge_heights(const agents::sim::Site& site, const agents::CameraModel& camera,
                           const std::vector<SeenHeight>& seen, const floor::Trace& trace);

/// Returns the value that three quarters of them do not exceed; NaN of none.
double upper_quartile(std::vector<double> values);

}  // namespace weft::evaluate::ceiling
