#include "agents/methods/ceiling/chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "agents/methods/ceiling/corner_grid.hpp"
#include "agents/methods/ceiling/rectified.hpp"
#include "agents/methods/ceiling/same_scale.hpp"
#include "agents/perception/attitude.hpp"
#include "agents/perception/hamming.hpp"
#include "agents/perception/plane/level_points.hpp"

namespace weft::agents {
namespace {

constexpr double kFarthestM = 100.0;  // from the centre: what is farther, a damaged content may have put there

/// Describes a feature of a place in the frame of the chart's centre.
struct Laid {
  PlaneFeature feature;  ///< level
  Eigen::Vector3d eye = Eigen::Vector3d::Zero();
  double variance_m2 = 0.0;  ///< of its place, each way
  std::uint32_t place = 0;

  /// Returns where it lies if it is at another height.
  Eigen::Vector2d at_height(double above_floor_m) const {
    const double share = (above_floor_m - eye.z()) / (feature.above_floor_m - eye.z());
    return eye.head<2>() + share * (feature.on_plane - eye.head<2>());
  }
  /// Returns by how much a metre of height moves it.
  Eigen::Vector2d slope() const { return (feature.on_plane - eye.head<2>()) / (feature.above_floor_m - eye.z()); }
};

/// Lays out what one place shows, its attitude undone, at the chart's scale.
void lay_out(const CeilingConfig& config, const CeilingContent& content, const ChartPlace<CeilingContent>& place,
             std::uint32_t number, std::vector<Laid>& out) {
  const Pose2 centre_from_place = planar(place.centre_from_place);
  const Eigen::Matrix3d covariance = planar_covariance(place.centre_from_place);
  const std::vector<Eigen::Vector2d> at = level_points(content.camera, content.attitude, content.features);
  const Eigen::Vector3d eye = level_from_body(content.attitude) * content.camera.robot_from_camera.translation;
  const double own_m = config.feature_sigma_px * metres_per_pixel(config, content.ceiling_m);
  for (std::size_t i = 0; i < at.size(); ++i) {
    Laid laid{content.features[i], eye, 0.0, number};
    laid.eye.head<2>() = centre_from_place * Eigen::Vector2d(eye.head<2>());
    laid.feature.on_plane = centre_from_place * at[i];
    laid.feature.heading_rad = wrap_angle(laid.feature.heading_rad + centre_from_place.heading);
    if (!(laid.feature.on_plane.norm() < kFarthestM) || !(laid.feature.above_floor_m > laid.eye.z())) continue;
    const double by_height_m = laid.slope().norm() * laid.feature.above_floor_sigma_m;
    laid.variance_m2 = own_m * own_m + by_height_m * by_height_m + 0.5 * (covariance(0, 0) + covariance(1, 1)) +
                       covariance(2, 2) * at[i].squaredNorm();
    out.push_back(laid);
  }
}

/// Puts features together that are one corner.
class Mosaicker {
 public:
  Mosaicker(const CeilingConfig& config, double within_m, const std::vector<Laid>& all)
      : most_bits_(config.most_bits), within_m_(within_m), grid_(grid_over(all)) {}

  void add(const Laid& laid) {
    if (const std::optional<std::uint32_t> corner = same_corner(laid)) {
      join(laid, *corner);
      return;
    }
    corners_.push_back({laid.feature, 1.0 / laid.variance_m2, 1});
    best_.push_back(laid);
    last_place_.push_back(laid.place);
    grid_.add(laid.feature.on_plane);
  }
  std::vector<ChartCorner> take() { return std::move(corners_); }

 private:
  static CornerGrid grid_over(const std::vector<Laid>& all) {
    Eigen::Vector2d low = Eigen::Vector2d::Zero();
    Eigen::Vector2d high = Eigen::Vector2d::Zero();
    for (const Laid& laid : all) {
      low = low.cwiseMin(laid.feature.on_plane);
      high = high.cwiseMax(laid.feature.on_plane);
    }
    return {low, high};
  }

  /// Returns the corner that a feature shows, the one most like it: another place's, that lies as near as noise lets
  /// it, and the height, which moves what is seen from elsewhere. Both are compared at the height that is known
  /// better.
  std::optional<std::uint32_t> same_corner(const Laid& laid) const {
    constexpr double sigmas = 2.0;
    std::optional<std::uint32_t> found;
    int least_bits = most_bits_ + 1;
    grid_.near(laid.feature.on_plane, CornerGrid::cell_m, [&](std::uint32_t i) {
      if (last_place_[i] == laid.place) return;
      const PlaneFeature& there = corners_[i].feature;
      const bool knows_better = laid.feature.above_floor_sigma_m < there.above_floor_sigma_m;
      const PlaneFeature& better = knows_better ? laid.feature : there;
      const double off_m = (laid.at_height(better.above_floor_m) - moved_to(i, better.above_floor_m)).norm();
      const double by_height_m = better.above_floor_sigma_m * (laid.slope() - best_[i].slope()).norm();
      if (off_m > std::min(within_m_ + sigmas * by_height_m, CornerGrid::cell_m)) return;
      const int bits = hamming(laid.feature.descriptor, there.descriptor);
      if (bits >= least_bits) return;
      least_bits = bits;
      found = i;
    });
    return found;
  }

  /// Returns where a corner lies if it is at another height, by the view that has it best.
  Eigen::Vector2d moved_to(std::uint32_t corner, double above_floor_m) const {
    const Laid& best = best_[corner];
    const Eigen::Vector2d by_height =
        best.at_height(above_floor_m) - best.at_height(corners_[corner].feature.above_floor_m);
    return corners_[corner].feature.on_plane + by_height;
  }

  void join(const Laid& laid, std::uint32_t number) {
    ChartCorner& corner = corners_[number];
    PlaneFeature& feature = corner.feature;
    if (laid.feature.above_floor_sigma_m < feature.above_floor_sigma_m) {
      feature.on_plane = moved_to(number, laid.feature.above_floor_m);
      feature.above_floor_m = laid.feature.above_floor_m;
      feature.above_floor_sigma_m = laid.feature.above_floor_sigma_m;
    }
    const double more = 1.0 / laid.variance_m2;
    const double all = corner.information_m2 + more;
    feature.on_plane += more / all * (laid.at_height(feature.above_floor_m) - feature.on_plane);
    corner.information_m2 = all;
    ++corner.places;
    last_place_[number] = laid.place;
    if (laid.variance_m2 >= best_[number].variance_m2) return;
    feature.descriptor = laid.feature.descriptor;
    feature.heading_rad = laid.feature.heading_rad;
    best_[number] = laid;
  }

  int most_bits_;
  double within_m_;
  CornerGrid grid_;
  std::vector<ChartCorner> corners_;
  std::vector<Laid> best_;                 ///< the view by which each is known best
  std::vector<std::uint32_t> last_place_;  ///< that showed each
};

}  // namespace

const ChartedCeiling* CeilingChart::find(const PlaceId& id) const {
  const auto found = std::find_if(places.begin(), places.end(), [&](const auto& place) { return place.id == id; });
  return found == places.end() ? nullptr : &*found;
}

const ChartedCeiling* CeilingChart::nearest(const Eigen::Vector2d& in_centre) const {
  const ChartedCeiling* found = nullptr;
  double least_m = std::numeric_limits<double>::infinity();
  for (const ChartedCeiling& place : places) {
    const double apart_m = (place.centre_from_place.translation() - in_centre).norm();
    if (!place.content || !(apart_m < least_m)) continue;
    least_m = apart_m;
    found = &place;
  }
  return found;
}

std::vector<PlaneFeature> CeilingChart::around(const Eigen::Vector2d& in_centre, double reach_m, std::size_t most,
                                               const Pose2& centre_from_place) const {
  std::vector<const ChartCorner*> near;
  for (const ChartCorner& corner : corners)
    if ((corner.feature.on_plane - in_centre).norm() < reach_m) near.push_back(&corner);
  std::stable_sort(near.begin(), near.end(),
                   [](const ChartCorner* a, const ChartCorner* b) { return a->places > b->places; });
  if (near.size() > most) near.resize(most);
  const Pose2 place_from_centre = centre_from_place.inverse();
  std::vector<PlaneFeature> features;
  for (const ChartCorner* const corner : near) {
    features.push_back(corner->feature);
    features.back().on_plane = place_from_centre * corner->feature.on_plane;
    features.back().heading_rad = wrap_angle(corner->feature.heading_rad + place_from_centre.heading);
  }
  return features;
}

CeilingChart chart_ceiling(const CeilingConfig& config, const std::vector<ChartPlace<CeilingContent>>& around) {
  CeilingChart chart;
  const CeilingContent* first = nullptr;
  std::vector<Laid> all;
  for (const ChartPlace<CeilingContent>& place : around) {
    const auto number = static_cast<std::uint32_t>(chart.places.size());
    chart.places.push_back({place.id, planar(place.centre_from_place), place.content});
    if (!place.content || std::holds_alternative<AlongPath>(place.centre_from_place)) continue;
    if (first == nullptr) {
      first = place.content.get();
      chart.ceiling_m = first->ceiling_m;
    }
    if (shared_ceiling(*first, *place.content).apart_sigmas > config.most_scale_sigmas) continue;
    lay_out(config, at_ceiling(*place.content, chart.ceiling_m), place, number, all);
  }
  Mosaicker mosaic(config, config.consensus_px * metres_per_pixel(config, chart.ceiling_m), all);
  for (const Laid& laid : all) mosaic.add(laid);
  chart.corners = mosaic.take();
  return chart;
}

}  // namespace weft::agents
