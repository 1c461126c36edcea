#include "clients/evaluate/ceiling/drive_watch.hpp"

#include <utility>
#include <variant>

namespace weft::evaluate::ceiling {

using namespace agents;

Result<std::shared_ptr<DriveWatch>> DriveWatch::make(const CeilingConfig& settings, const CameraModel& camera) {
  Result<Ceiling> whole = Ceiling::make(settings, camera);
  if (!whole) return fail(whole.error());
  Result<Ceiling> flat = Ceiling::make(ceiling::one_plane(settings), camera);
  if (!flat) return fail(flat.error());
  return std::shared_ptr<DriveWatch>(new DriveWatch(std::move(*whole), std::move(*flat)));
}

DriveWatch::DriveWatch(Ceiling whole, Ceiling flat)
    : flat_(std::move(flat)),
      published_(flat_.camera()),
      heights_(std::move(whole)),
      away_m_(flat_.config().height_m - flat_.camera().robot_from_camera.translation.z()) {}

Look DriveWatch::look_of(const std::shared_ptr<DriveWatch>& watch) {
  return [watch](const Ceiling::Odometry& odometry, const View* view, const Motion& motion) {
    watch->look(odometry, view, motion);
  };
}

void DriveWatch::look(const Ceiling::Odometry& odometry, const View* view, const Motion& motion) {
  constexpr double kept_every_m = 1.5;
  const std::size_t sample = one_plane_.size();
  const Step step = flat_.observe(flat_odometry_, view, motion);
  const Pose2 before = one_plane_.empty() ? Pose2{} : one_plane_.back();
  one_plane_.push_back(before * planar(step.previous_from_current));
  const Image* const image = view == nullptr ? nullptr : std::get_if<Image>(&view->data);
  if (image != nullptr) published_.add(*image);
  const Eigen::Vector2d at = away_m_ * published_.robot_in_start();
  mosaic_poses_.push_back({at.x(), at.y(), 0.0});
  heights_.look(sample, odometry);
  if (image == nullptr) return;
  const auto since_kept = [&] {
    return (one_plane_[kept_.back().sample].inverse() * one_plane_.back()).translation();
  };
  if (kept_.empty() || since_kept().norm() > kept_every_m) kept_.push_back({sample, *image});
}

floor::Trace with_odometry(floor::Trace trace, const std::vector<Pose2>& start_from_robot) {
  for (std::size_t i = 0; i < trace.moments.size(); ++i) trace.moments[i].start_from_robot = start_from_robot.at(i);
  return trace;
}

}  // namespace weft::evaluate::ceiling
