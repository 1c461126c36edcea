// Tells apart two places that look alike: where one has a plain wall, which shows no points and no free floor either,
// the other may look on to what stands behind.
#include "agents/methods/topometric/contradiction.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "agents/methods/topometric/level_relation.hpp"
#include "agents/methods/topometric/sight.hpp"
#include "agents/methods/topometric/topometric.hpp"

namespace weft::agents {

static_assert(Contradicts<Topometric>);

namespace {

constexpr double kPart = 0.08;            // tangent of a part's width and height
constexpr double kNearestM = 0.8;         // of what is looked for,
constexpr double kFarthestM = 3.9;        // at most,
constexpr double kOfRange = 0.95;         // and of what a pair knows the depth of
constexpr double kAsFarM = 0.3;           // apart, along the ray, two views may have one thing
constexpr double kAboveFloorM = 0.15;     // a floor's texture fades with distance
constexpr std::size_t kFewestPoints = 3;  // of a part, for something to be expected there
constexpr std::size_t kOnePast = 1;       // points nearer than what is expected: one may be wrong

/// Sorts points into parts of a view, by their depths.
class DepthView {
 public:
  DepthView(const StereoRig& rig, const Pose3& place_from_camera)
      : rig_(rig),
        camera_from_place_(place_from_camera.inverse()),
        columns_(parts_of(rig.width, rig.focal_px)),
        rows_(parts_of(rig.height, rig.focal_px)),
        depths_m_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {}

  void add(const Eigen::Vector3d& in_place) {
    constexpr double nearest_m = 0.2;
    const Eigen::Vector3d at = camera_from_place_ * in_place;
    if (at.z() < nearest_m) return;
    const auto part_of = [&](double across, double centre_px) {
      return static_cast<int>(std::floor((across / at.z() + centre_px / rig_.focal_px) / kPart));
    };
    const int column = part_of(at.x(), rig_.cx);
    const int row = part_of(at.y(), rig_.cy);
    if (column >= 0 && column < columns_ && row >= 0 && row < rows_) depths_m_[index(column, row)].push_back(at.z());
  }
  /// Returns whether a pair can match what is as far away in a column: at the left image's left edge it lies outside
  /// of the right one.
  bool is_matched(int column, double depth_m) const {
    return column * kPart * rig_.focal_px >= rig_.disparity_px(depth_m);
  }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  const std::vector<double>& depths_m(int column, int row) const { return depths_m_[index(column, row)]; }
  /// Returns the depths in a part and in those around it.
  std::vector<double> depths_around_m(int column, int row) const {
    std::vector<double> all;
    for (int r = std::max(0, row - 1); r <= std::min(rows_ - 1, row + 1); ++r)
      for (int c = std::max(0, column - 1); c <= std::min(columns_ - 1, column + 1); ++c)
        all.insert(all.end(), depths_m(c, r).begin(), depths_m(c, r).end());
    return all;
  }

 private:
  /// Returns how many parts an image has across or down; 0 for one wider than any lens sees, as a content may state.
  static int parts_of(int pixels, double focal_px) {
    constexpr double most = 100.0;
    const double parts = pixels / focal_px / kPart;
    return parts > 0.0 && parts < most ? static_cast<int>(parts) : 0;
  }
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
  }

  const StereoRig& rig_;
  Pose3 camera_from_place_;
  int columns_;
  int rows_;
  std::vector<std::vector<double>> depths_m_;
};

/// Returns how far away a part shows something that can be looked for up to `within_m`; none: it does not.
std::optional<double> expected_depth_m(std::vector<double> depths_m, double within_m) {
  if (depths_m.size() < kFewestPoints) return std::nullopt;
  std::nth_element(depths_m.begin(), depths_m.begin() + kOnePast, depths_m.end());
  const double depth_m = depths_m[kOnePast];
  if (depth_m < kNearestM || depth_m > within_m) return std::nullopt;
  return depth_m;
}

void compare(const std::vector<double>& shown_m, double expected_m, ExpectedInView& expected) {
  const auto any = [&](const auto& is_so) {
    return std::ranges::any_of(shown_m, [&](double shown) { return is_so(shown - expected_m); });
  };
  if (any([](double farther_m) { return std::abs(farther_m) <= kAsFarM; })) {
    ++expected.seen;
  } else if (any([](double farther_m) { return farther_m < -kAsFarM; })) {
    return;  // it may stand behind that
  } else {
    ++(shown_m.empty() ? expected.blank : expected.through);
  }
}

/// Returns how far away a place shows all that can be matched: what is farthest is left out where there is too much.
double shown_within_m(const TopometricConfig& config, const TopometricContent& content) {
  const double range_m = std::min(kFarthestM, kOfRange * sight_range_m(config.sight, content.rig));
  if (content.cloud.points.size() < static_cast<std::size_t>(config.place.most_points)) return range_m;
  const Eigen::Vector3f camera = content.rig.robot_from_camera.translation.cast<float>();
  float farthest_m = 0.0F;
  for (const Eigen::Vector3f& point : content.cloud.points)
    farthest_m = std::max(farthest_m, (point - camera).norm());
  return std::min(range_m, kOfRange * static_cast<double>(farthest_m));
}

}  // namespace

ExpectedInView expected_in_view(const TopometricContent& a, const PlaceCloud& b, const Pose3& a_from_b,
                                double within_m) {
  ExpectedInView expected;
  if (a.cloud.place_from_frames.empty()) return expected;
  const Pose3 a_from_camera = a.cloud.place_from_frames.back() * a.rig.robot_from_camera;
  DepthView shown(a.rig, a_from_camera);
  for (const Eigen::Vector3f& point : a.cloud.points) shown.add(point.cast<double>());
  DepthView looked_for(a.rig, a_from_camera);
  for (const Eigen::Vector3f& point : b.points)
    if (const Eigen::Vector3d in_a = a_from_b * Eigen::Vector3d(point.cast<double>()); in_a.z() > kAboveFloorM)
      looked_for.add(in_a);
  for (int row = 0; row < shown.rows(); ++row)
    for (int column = 0; column < shown.columns(); ++column)
      if (const auto depth_m = expected_depth_m(looked_for.depths_m(column, row), within_m);
          depth_m && shown.is_matched(column, *depth_m))
        compare(shown.depths_around_m(column, row), *depth_m, expected);
  return expected;
}

double Topometric::contradiction(const Content& a, const Content& b, const Relation& a_from_b) const {
  // A crate that has come or gone hides what is around it, too, and bares blank walls there.
  constexpr double of_through = 2.0;
  // One view of a place shows a few parts that another does not, at edges and where texture is faint.
  constexpr double fewest = 5.0;
  const auto parts = [](const ExpectedInView& expected) {
    const double told = static_cast<double>(expected.blank) - of_through * static_cast<double>(expected.through);
    return told < fewest ? 0.0 : told;
  };
  const Pose3 pose = level_prior(config_.relate, a, b, a_from_b).a_from_b;
  return parts(expected_in_view(a, b.cloud, pose, shown_within_m(config_, a))) +
         parts(expected_in_view(b, a.cloud, pose.inverse(), shown_within_m(config_, b)));
}

}  // namespace weft::agents
