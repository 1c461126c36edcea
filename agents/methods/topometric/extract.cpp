#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "agents/methods/topometric/sight.hpp"
#include "agents/methods/topometric/space_features.hpp"
#include "agents/methods/topometric/topometric.hpp"
#include "agents/perception/clouds/moved.hpp"
#include "agents/perception/clouds/pcl_check.hpp"

namespace weft::agents {
namespace {

tl::unexpected<Refusal> not_a_place(std::string_view reason, double measured, double bound) {
  return tl::unexpected<Refusal>(Refusal{reason, measured, bound});
}

/// Moves all of a cloud into another frame.
void move_to(const Pose3& other_from_place, PlaceCloud& cloud) {
  cloud.points = moved(cloud.points, other_from_place);
  cloud.cameras = moved(cloud.cameras, other_from_place);
  for (Pose3& pose : cloud.place_from_frames) pose = other_from_place * pose;
}

/// Keeps at most so many points, those that were seen from nearest, none above `highest_m`.
void thin_out(PlaceCloud& cloud, std::size_t most, double highest_m) {
  std::vector<float> away2(cloud.points.size());
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    away2[i] = (cloud.points[i] - cloud.cameras[cloud.frames[i]]).squaredNorm();
  std::vector<float> sorted = away2;
  float farthest = INFINITY;
  if (sorted.size() > most) {
    const auto bound = sorted.begin() + static_cast<std::ptrdiff_t>(most);
    std::nth_element(sorted.begin(), bound, sorted.end());
    farthest = *bound;
  }
  std::size_t kept = 0;
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    if (away2[i] >= farthest || static_cast<double>(cloud.points[i].z()) > highest_m) continue;
    cloud.points[kept] = cloud.points[i];
    cloud.frames[kept++] = cloud.frames[i];
  }
  cloud.points.resize(kept);
  cloud.frames.resize(kept);
}

/// Finds the floor of a cloud that is level already but for what single views have got wrong.
std::optional<pcl_check::FloorFound> floor_of(const PlaceCloud& cloud) {
  constexpr float near_m = 0.2F;
  std::vector<Eigen::Vector3f> low;
  for (const Eigen::Vector3f& point : cloud.points)
    if (std::abs(point.z()) < near_m) low.push_back(point);
  return pcl_check::find_floor(low, pcl_check::FloorSearch{});
}

}  // namespace

/// Returns the pair of a view that may become a place.
OrRefusal<const StereoPair*> Topometric::pair_to_store(const Odometry& s, const View& view) const {
  const auto* const pair = std::get_if<StereoPair>(&view.data);
  if (pair == nullptr) return not_a_place("not_a_pair", 0.0, 1.0);
  const Rectifier& rectifier = odometry_.stereo().rectifier();
  if (!rectifier.fits(*pair)) return not_a_place("wrong_size", pair->left.width, rectifier.left().width);
  if (!s.has_seen || !s.window) return not_a_place("blind", s.blind_m, 0.0);
  return pair;
}

OrRefusal<TopometricContent> Topometric::extract(const Odometry& s, const View& view) const {
  const OrRefusal<const StereoPair*> pair = pair_to_store(s, view);
  if (!pair) return tl::unexpected(pair.error());
  OrRefusal<TopometricContent> content = made_of(*s.window, s, **pair);
  if (content) content->scan = s.scan;
  return content;
}

/// Returns what is stored of where the robot is now: the window's clouds, and the features of a pair.
OrRefusal<TopometricContent> Topometric::made_of(const CloudWindow& window, const Odometry& s,
                                                 const StereoPair& pair) const {
  TopometricContent content;
  content.rig = rig();
  content.clear_m = static_cast<float>(config_.scan.range_m);
  content.floor.level_from_odometry = s.level_from_robot;
  content.cloud = window.snapshot(s.odometry_from_robot * s.level_from_robot.inverse());
  if (const auto floor = floor_of(content.cloud)) {
    const Pose3 better = floor->level_from_frame() * s.level_from_robot;
    content.floor.level_from_odometry =
        level_above(better.rotation.inverse() * Eigen::Vector3d::UnitZ(), better.translation.z());
    move_to(content.floor.level_from_odometry * s.level_from_robot.inverse(), content.cloud);
    content.floor.points = static_cast<std::uint32_t>(floor->points);
  }
  thin_out(content.cloud, static_cast<std::size_t>(config_.place.most_points), config_.sight.highest_m);
  content.features =
      space_features(config_.place, odometry_.stereo().rectifier(), pair, content.floor.level_from_odometry);
  if (content.cloud.points.size() < static_cast<std::size_t>(config_.place.fewest_points) &&
      content.features.size() < static_cast<std::size_t>(config_.place.fewest_features))
    return not_a_place("too_blank", static_cast<double>(content.cloud.points.size()), config_.place.fewest_points);
  return content;
}

}  // namespace weft::agents
