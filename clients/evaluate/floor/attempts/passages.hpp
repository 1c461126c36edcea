#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "agents/bodies/sim/sim_body.hpp"
#include "agents/methods/floor/floor.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// Holds one sample of a robot that rolls by.
struct Look {
  agents::Step step;                            ///< since the look before
  Pose2 site_from_robot;                        ///< truth; for judging only
  std::optional<agents::FloorContent> content;  ///< none: the frame was dropped, or the method refused it
};

/// Holds a few consecutive samples.
struct Passage {
  std::vector<Look> looks;
  std::optional<agents::FloorContent> mirrored;  ///< the last view with left and right changed
};

/// Puts a simulated robot down anywhere and rolls it on for a few samples; what it sees passes through the method's
/// own odometry. One body serves all passages, as making floor and camera costs more than a view.
class Passages {
 public:
  static constexpr double kFps = 10.0;
  static constexpr int kLooks = 6;

  /// Makes a robot whose frame rate is kFps. Errors of the body and of the method.
  static Result<Passages> make(agents::sim::SimBodyConfig config);

  /// Rolls by so that the robot is at `site_from_robot` in the middle of the passage.
  Result<Passage> pass(const Pose2& site_from_robot, const agents::Twist& moving);

  const agents::Floor& method() const { return method_; }

 private:
  Passages(std::unique_ptr<agents::sim::SimulatedBody> body, agents::Floor method)
      : body_(std::move(body)), method_(std::move(method)) {}

  std::unique_ptr<agents::sim::SimulatedBody> body_;
  agents::Floor method_;
};

}  // namespace weft::evaluate::floor
