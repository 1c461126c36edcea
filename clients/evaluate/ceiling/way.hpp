#pragma once
#include <memory>
#include <optional>

#include "clients/evaluate/ceiling/drive_watch.hpp"
#include "clients/evaluate/ceiling/scenes.hpp"
#include "clients/evaluate/ceiling/score.hpp"
#include "clients/evaluate/floor/drive.hpp"
#include "core/result.hpp"

namespace weft::evaluate::ceiling {

/// Holds a way that a robot was taught, with what was watched meanwhile.
struct Way {
  Scene scene;       ///< its robot stands where the line begins
  Calibrated given;  ///< to its robot
  floor::Taught taught;
  std::shared_ptr<DriveWatch> watch;

  const floor::Trace& trace() const { return taught.traces.front(); }
};

/// Teaches the robot, which is given that, the scene's line. None: stopped.
Result<std::optional<Way>> teach_way(const Scene& scene, const Driven& driven, const Calibrated& given);

/// Adds how well a repeat has kept to what was taught: lateral_rms_mm, lateral_worst_mm, goal_mm, goal_deg (numbers
/// only of a robot that has arrived), arrived, fixes, wrong_fixes.
void add_path(const Way& way, const floor::Repeated& repeated, Score& score);

/// Adds how often the 95 % region of odometry's covariance holds the truth: held_1m_percent, held_10m_percent, over
/// all stretches of the drives.
void add_held(const std::vector<const floor::Trace*>& traces, Score& score);

/// Returns the points (driven, beside the taught path): metres, millimetres.
std::vector<std::array<double, 2>> beside_of(const Way& way, const floor::Repeated& repeated);

}  // namespace weft::evaluate::ceiling
