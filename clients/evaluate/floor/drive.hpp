#pragma once
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "agents/bodies/sim/sim_body.hpp"
#include "agents/perception/camera_model.hpp"
#include "clients/evaluate/floor/driven_robot.hpp"
#include "clients/evaluate/floor/trace.hpp"
#include "clients/evaluate/taught_map.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// Says which robot drives, in which site, on which day.
struct Drive {
  agents::sim::SimBodyConfig body;                 ///< its truth_path: a file to be made and removed
  std::function<bool()> asked_to_stop;             ///< asked at every sample
  std::optional<agents::CameraModel> camera = {};  ///< as it was calibrated; none: as the site gives it
  MakeNavigator navigator = floor_navigator;
};

/// Holds what robots were taught, one experience after the other, and where its places truly are.
struct Taught {
  TaughtMap map;
  std::vector<Trace> traces;
  PlaceSet places;
  PlaceId last;
  /// Describes the experience that was taught last, with what teaching foretold of it; of a method that cannot
  /// foretell: nothing.
  agents::TeachReport way;
  bool refined = false;  ///< the map holds the same as its method has refined it, not as it was kept
};

/// Holds a drive along what was taught by the robot's own control.
struct Repeated {
  Trace trace;
  bool localised = false;  ///< found itself before it drove
  bool arrived = false;
  std::string ended;  ///< why it stands, when it has not arrived
};

/// Has a hand lead the robot along the line; nothing is taught, its odometry is what counts. None: stopped.
Result<std::optional<Trace>> lead(const Drive& drive, const std::vector<agents::SitePoint>& line);

/// Teaches a robot that a hand leads along the line; a method that refines does so before the run is taken in. When
/// something has been taught before, it looks where it is first. Returns false when it was stopped. refused: it did
/// not find out.
Result<bool> teach(const Drive& drive, const std::vector<agents::SitePoint>& line, Taught& taught);

/// Has a robot that is told nothing but the map find where it is and drive to the last place taught. None: stopped.
Result<std::optional<Repeated>> repeat(const Drive& drive, const Taught& taught);

}  // namespace weft::evaluate::floor
