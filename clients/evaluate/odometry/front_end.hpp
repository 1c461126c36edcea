#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agents/perception/camera_model.hpp"
#include "agents/perception/planar_motion.hpp"
#include "agents/perception/view.hpp"

namespace weft::evaluate::odometry {

/// Finds the motion between a keyframe and a view. Front ends differ in this alone: keyframes, prior, robust
/// homography and fit are the same for all (KeyframeOdometry).
class FrontEnd {
 public:
  virtual ~FrontEnd() = default;
  /// Looks at a view, which match() and begin() are then about.
  virtual void look(const agents::Image& image) = 0;
  /// Makes the view last looked at the keyframe from now on.
  virtual void begin() = 0;
  /// Returns keyframe_from_robot of the view last looked at, from where it is expected. None: not found.
  virtual std::optional<agents::PlanarFit> match(const agents::PlanarState& expected) = 0;
};

/// Return the names of all front ends, and the one of a name. They match with `prior`.
const std::vector<std::string>& front_ends();
std::unique_ptr<FrontEnd> make_front_end(const std::string& name, const agents::CameraModel& camera,
                                         const agents::AttitudePrior& prior);

}  // namespace weft::evaluate::odometry
