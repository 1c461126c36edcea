#include "clients/evaluate/floor/driven_robot.hpp"

#include <string>
#include <system_error>
#include <utility>

#include "agents/methods/floor/floor.hpp"
#include "agents/navigation/navigator_of.hpp"
#include "clients/evaluate/exposed.hpp"
#include "clients/evaluate/truth.hpp"

namespace weft::evaluate::floor {

using namespace agents;

Result<std::unique_ptr<Navigator>> floor_navigator(const CameraModel& camera, std::shared_ptr<SeenStep> seen) {
  Result<Floor> floor = Floor::make({}, camera);
  if (!floor) return fail(floor.error());
  return make_navigator(Watched<Floor>(std::move(*floor), std::move(seen)), NavigationConfig{});
}

Result<DrivenRobot> DrivenRobot::make(const sim::SimBodyConfig& config,
                                      const std::optional<agents::CameraModel>& camera,
                                      const MakeNavigator& navigator) {
  const std::filesystem::path truth = config.truth_path.value_or("");
  std::error_code problem;
  std::filesystem::remove(truth, problem);
  if (problem) return fail(ErrorCode::unavailable, truth.string() + ": " + problem.message());
  Result<std::unique_ptr<Body>> body = sim::make_sim_body(config);
  if (!body) return fail(body.error());
  Result<DrivenRobot> robot = of(std::move(*body), camera, navigator);
  if (robot) robot->truth_ = truth;
  return robot;
}

Result<DrivenRobot> DrivenRobot::of(std::unique_ptr<Body> body, const std::optional<agents::CameraModel>& camera,
                                    const MakeNavigator& navigator) {
  DrivenRobot robot;
  robot.seen_ = std::make_shared<SeenStep>();
  Result<std::unique_ptr<Navigator>> made = navigator(camera.value_or(body->rig().camera()), robot.seen_);
  if (!made) return fail(made.error());
  robot.navigator_ = std::move(*made);
  robot.body_ = std::move(body);
  return robot;
}

DrivenRobot::~DrivenRobot() {
  std::error_code ignored;  // a left-over file is removed at the next start
  if (body_ && !truth_.empty()) std::filesystem::remove(truth_, ignored);
}

Result<DrivenRobot::Stepped> DrivenRobot::step(const MapView& map) {
  Result<Sample> sample = body_->step(command_);
  if (!sample) return fail(sample.error());
  Stepped stepped;
  if (left_out_.contains(sample->frame)) sample->views.clear();
  stepped.has_view = !sample->views.empty();
  stepped.hand_done = sample->hand_done;
  stepped.navigated = navigator_->step(*sample, map);
  command_ = stepped.navigated.command;
  expose(*body_, stepped.navigated);
  start_from_robot_ = start_from_robot_ * planar(seen_->step.previous_from_current);
  Moment moment;
  moment.frame = sample->frame;
  moment.sensor_s = now_s_ = seconds(sample->time.time_since_epoch());
  moment.start_from_robot = start_from_robot_;
  moment.step_covariance = planar_covariance(seen_->step.previous_from_current);
  moment.step_common = seen_->step.common;
  moment.seen = seen_->step.seen;
  moment.matches = seen_->matches;
  moment.lost = stepped.navigated.lost;
  moment.following = stepped.navigated.following;
  if (const std::optional<Fix>& fix = stepped.navigated.fix) {
    moment.fix = FixSeen{fix->place, planar(fix->evidence.a_from_b), planar(fix->place_from_robot)};
  }
  if (!stepped.navigated.kept.empty()) moment.kept = stepped.navigated.kept.back().place.id;
  trace_.moments.push_back(moment);
  for (const Refusal& refusal : stepped.navigated.refusals) ++trace_.refusals[std::string(refusal.reason)];
  return stepped;
}

void DrivenRobot::note_last(const std::vector<Kept>& kept) {
  if (!kept.empty()) trace_.moments.back().kept = kept.back().place.id;
}

Result<Trace> DrivenRobot::finish() {
  if (truth_.empty()) return std::move(trace_);
  const auto truth = read_truth(truth_);
  if (!truth) return fail(truth.error());
  for (Moment& moment : trace_.moments) {
    const auto found = truth->find(moment.frame);
    if (found == truth->end()) {
      return fail(ErrorCode::internal, truth_.string() + ": has no frame " + std::to_string(moment.frame) +
                                           "; is somebody else using it?");
    }
    moment.true_s = found->second.true_s;
    moment.site_from_robot = found->second.site_from_robot;
  }
  return std::move(trace_);
}

}  // namespace weft::evaluate::floor
