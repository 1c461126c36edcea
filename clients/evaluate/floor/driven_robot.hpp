#pragma once
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "agents/bodies/sim/sim_body.hpp"
#include "agents/navigation/navigator.hpp"
#include "agents/perception/camera_model.hpp"
#include "clients/evaluate/floor/trace.hpp"
#include "clients/evaluate/floor/watched.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// Makes the navigator of a robot with that camera, whose method notes each step into `seen`. Errors of the method.
using MakeNavigator = std::function<Result<std::unique_ptr<agents::Navigator>>(const agents::CameraModel& camera,
                                                                               std::shared_ptr<SeenStep> seen)>;
/// Makes one of the method `floor`, every setting at its default.
Result<std::unique_ptr<agents::Navigator>> floor_navigator(const agents::CameraModel& camera,
                                                           std::shared_ptr<SeenStep> seen);

/// Joins a body, mostly a simulated one, to the navigator that its agent would have. The body's command is the
/// navigator's of the sample before, as in the agent's process, and so is what the navigator wishes of the exposure.
class DrivenRobot {
 public:
  /// Makes a simulated one. Its truth goes to a file at config.truth_path, made anew and removed again. `camera`: as
  /// it was calibrated; none: as the body says. Errors of body and method.
  static Result<DrivenRobot> make(const agents::sim::SimBodyConfig& config,
                                  const std::optional<agents::CameraModel>& camera,
                                  const MakeNavigator& navigator = floor_navigator);
  /// Makes one of any other body; what it drives has no truth. Errors of the method.
  static Result<DrivenRobot> of(std::unique_ptr<agents::Body> body,
                                const std::optional<agents::CameraModel>& camera = {},
                                const MakeNavigator& navigator = floor_navigator);
  DrivenRobot(DrivenRobot&&) = default;
  DrivenRobot& operator=(DrivenRobot&&) = delete;
  ~DrivenRobot();

  agents::Body& body() { return *body_; }
  agents::Navigator& navigator() { return *navigator_; }
  /// Keeps the views of these frames from the navigator.
  void leave_out(std::set<std::uint64_t> frames) { left_out_ = std::move(frames); }
  double now_s() const { return now_s_; }  ///< by the samples' stamps

  struct Stepped {
    agents::Navigated navigated;
    bool has_view = false;
    bool hand_done = false;
  };
  /// Takes one sample, and notes it in the trace.
  Result<Stepped> step(const agents::MapView& map);

  /// Notes in the trace what the end of teaching kept, of the newest sample.
  void note_last(const std::vector<agents::Kept>& kept);

  /// Returns what was driven, with its truth beside it. The robot is not to be used any more.
  Result<Trace> finish();

 private:
  DrivenRobot() = default;

  std::filesystem::path truth_;  // empty: none
  std::set<std::uint64_t> left_out_;
  std::unique_ptr<agents::Body> body_;
  std::unique_ptr<agents::Navigator> navigator_;
  std::shared_ptr<SeenStep> seen_;
  agents::Twist command_;
  Pose2 start_from_robot_;
  double now_s_ = 0.0;
  Trace trace_;
};

}  // namespace weft::evaluate::floor
