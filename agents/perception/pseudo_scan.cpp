#include "agents/perception/pseudo_scan.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "agents/perception/out_of_bounds.hpp"

namespace weft::agents {
namespace {

/// Holds the ranges of one bearing's points.
struct Bin {
  std::vector<float> slice;
  std::vector<float> floor;
  bool has_drop = false;
  float drop_m = 0.0F;  ///< of the nearest point below the floor
};

void put(const PseudoScanConfig& config, const Eigen::Vector3f& point, float range_m, Bin& bin) {
  const auto z = static_cast<double>(point.z());
  if (z >= config.slice_from_m && z <= config.body_height_m) {
    bin.slice.push_back(range_m);
  } else if (std::abs(z) < config.floor_m) {
    bin.floor.push_back(range_m);
  } else if (z <= -config.floor_m) {
    bin.drop_m = bin.has_drop ? std::min(bin.drop_m, range_m) : range_m;
    bin.has_drop = true;
  }
}

/// Returns how far floor was seen without a gap; 0 where it does not begin near enough.
double floor_seen_m(const PseudoScanConfig& config, std::vector<float>& floor) {
  std::sort(floor.begin(), floor.end());
  double seen_m = 0.0;
  for (const float range : floor) {
    const double may_be_m = seen_m > 0.0 ? seen_m + config.floor_gap_m : config.floor_from_m;
    if (static_cast<double>(range) > may_be_m) break;
    seen_m = static_cast<double>(range);
  }
  return seen_m;
}

Beam beam_of(const PseudoScanConfig& config, Bin& bin, double bearing_rad) {
  Beam beam;
  beam.bearing_rad = bearing_rad;
  const double floor_m = floor_seen_m(config, bin.floor);
  const auto rank = static_cast<std::ptrdiff_t>(config.rank);
  if (static_cast<std::ptrdiff_t>(bin.slice.size()) >= rank) {
    std::nth_element(bin.slice.begin(), bin.slice.begin() + (rank - 1), bin.slice.end());
    beam.kind = Beam::Return::obstacle;
    beam.range_m = static_cast<double>(bin.slice[static_cast<std::size_t>(rank - 1)]);
    beam.sigma_m = config.sigma_by_square_1_m * beam.range_m * beam.range_m;
    const bool may_fall = bin.has_drop && static_cast<double>(bin.drop_m) < beam.range_m;
    beam.clear_m = may_fall ? std::min(floor_m, beam.range_m) : beam.range_m;
    return beam;
  }
  beam.clear_m = floor_m;
  // A floor that ends for want of range tells nothing of a wall.
  if (floor_m <= 0.0 || floor_m > config.range_m - 2.0 * config.floor_gap_m || bin.has_drop) return beam;
  beam.kind = Beam::Return::floor_edge;
  beam.range_m = floor_m;
  beam.sigma_m = std::hypot(config.edge_sigma_m, config.sigma_by_square_1_m * floor_m * floor_m);
  return beam;
}

}  // namespace

std::vector<Error> check(const PseudoScanConfig& config) {
  OutOfBounds out("pseudo_scan");
  const auto in = out.section("");
  in("slice_from_m", config.slice_from_m, Low::open, 0, 1);
  in("body_height_m", config.body_height_m, Low::open, config.slice_from_m, 5);
  in("bin_rad", config.bin_rad, Low::open, 0, 0.2);
  in("field_of_view_rad", config.field_of_view_rad, Low::open, 0, 2.0 * std::numbers::pi);
  in("rank", config.rank, Low::closed, 1, 20);
  in("range_m", config.range_m, Low::open, 0, 100);
  in("floor_m", config.floor_m, Low::open, 0, config.slice_from_m);
  in("floor_from_m", config.floor_from_m, Low::open, 0, 5);
  in("floor_gap_m", config.floor_gap_m, Low::open, 0, 2);
  in("edge_sigma_m", config.edge_sigma_m, Low::open, 0, 2);
  in("sigma_by_square_1_m", config.sigma_by_square_1_m, Low::closed, 0, 1);
  return std::move(out.issues);
}

Scan pseudo_scan(const PseudoScanConfig& config, std::span<const Eigen::Vector3f> level_points,
                 const Pose2& robot_from_scan) {
  const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(config.field_of_view_rad / config.bin_rad)));
  const double right_rad = -0.5 * static_cast<double>(count) * config.bin_rad;
  std::vector<Bin> bins(count);
  for (const Eigen::Vector3f& point : level_points) {
    const float range = std::hypot(point.x(), point.y());
    if (!(static_cast<double>(range) <= config.range_m) || !std::isfinite(point.z())) continue;
    const double bearing = std::atan2(static_cast<double>(point.y()), static_cast<double>(point.x()));
    const double at = std::floor((bearing - right_rad) / config.bin_rad);
    if (at < 0.0 || at >= static_cast<double>(count)) continue;
    put(config, point, range, bins[static_cast<std::size_t>(at)]);
  }
  Scan scan{robot_from_scan, {}};
  scan.beams.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    scan.beams.push_back(beam_of(config, bins[i], right_rad + (static_cast<double>(i) + 0.5) * config.bin_rad));
  return scan;
}

}  // namespace weft::agents
