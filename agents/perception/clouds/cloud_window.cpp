#include "agents/perception/clouds/cloud_window.hpp"

#include <algorithm>
#include <bit>
#include <limits>

#include "agents/perception/clouds/cell_table.hpp"

namespace weft::agents {
namespace {

constexpr double kLeastSigmaM = 0.002;  // near points do not outweigh everything

struct Voxel {
  Eigen::Vector3d points = Eigen::Vector3d::Zero();
  double weight = 0.0;
  double nearest_m = std::numeric_limits<double>::infinity();
  std::uint32_t frames = 0;  // a bit each
  std::uint16_t nearest_frame = 0;
};

/// Sorts the points of several frames into voxels.
class Voxels {
 public:
  Voxels(double voxel_m, const DepthNoise& noise, std::size_t expected)
      : per_m_(1.0 / voxel_m), noise_(noise), table_(expected) {}

  void add(const SeenFrame& frame, std::uint16_t index, const Pose3& place_from_robot) {
    const Eigen::Matrix3d rotation = place_from_robot.rotation.toRotationMatrix();
    for (const Eigen::Vector3f& point : frame.points_in_robot) {
      const Eigen::Vector3d seen = rotation * point.cast<double>() + place_from_robot.translation;
      if (!is_on_grid(seen, per_m_)) continue;
      const std::uint32_t number = table_.number_of(cell_of(seen, per_m_));
      if (number == voxels_.size()) voxels_.emplace_back();
      add_to(voxels_[number], seen, static_cast<double>((point - frame.camera_in_robot).norm()), index);
    }
  }
  const std::vector<Voxel>& voxels() const { return voxels_; }

 private:
  void add_to(Voxel& voxel, const Eigen::Vector3d& point, double range_m, std::uint16_t frame) const {
    const double sigma_m = noise_.sigma_m(range_m) + kLeastSigmaM;
    const double weight = 1.0 / (sigma_m * sigma_m);
    voxel.points += weight * point;
    voxel.weight += weight;
    voxel.frames |= 1U << frame;
    if (range_m >= voxel.nearest_m) return;
    voxel.nearest_m = range_m;
    voxel.nearest_frame = frame;
  }

  double per_m_;
  DepthNoise noise_;
  CellTable table_;
  std::vector<Voxel> voxels_;
};

}  // namespace

bool CloudWindow::add(SeenFrame frame) {
  blind_m_ = 0.0;
  if (!frames_.empty()) {
    const Pose3 moved = frames_.back().odometry_from_robot.inverse() * frame.odometry_from_robot;
    const double turned_rad = se3_log(moved).tail<3>().norm();
    if (moved.translation.norm() < config_.spacing_m && turned_rad < config_.spacing_rad) return false;
  }
  frames_.push_back(std::move(frame));
  if (frames_.size() > config_.frames) frames_.pop_front();
  return true;
}

void CloudWindow::go_blind(double metres) {
  blind_m_ += metres;
  if (blind_m_ > config_.most_blind_m) frames_.clear();
}

PlaceCloud CloudWindow::snapshot(const Pose3& odometry_from_place) const {
  PlaceCloud cloud;
  const Pose3 place_from_odometry = odometry_from_place.inverse();
  std::size_t points = 0;
  for (const SeenFrame& frame : frames_) points += frame.points_in_robot.size();
  Voxels voxels(config_.voxel_m, noise_, points / 4);
  for (const SeenFrame& frame : frames_) {
    const Pose3 place_from_robot = place_from_odometry * frame.odometry_from_robot;
    voxels.add(frame, static_cast<std::uint16_t>(cloud.cameras.size()), place_from_robot);
    cloud.place_from_frames.push_back(place_from_robot);
    cloud.clear_bearings.push_back(frame.clear_bearings);
    cloud.cameras.emplace_back((place_from_robot * frame.camera_in_robot.cast<double>()).cast<float>());
  }
  const std::size_t least = std::min<std::size_t>(config_.least_frames, frames_.size());
  for (const Voxel& voxel : voxels.voxels()) {
    if (static_cast<std::size_t>(std::popcount(voxel.frames)) < least) continue;
    cloud.points.emplace_back((voxel.points / voxel.weight).cast<float>());
    cloud.frames.push_back(voxel.nearest_frame);
  }
  return cloud;
}

}  // namespace weft::agents
