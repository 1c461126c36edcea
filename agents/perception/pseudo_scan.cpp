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
  int past = 0;         ///< points in the slice beyond the range
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

/// Counts a point that stands beyond the range, too far for its depth to be off by as much.
void put_past(const PseudoScanConfig& config, const Eigen::Vector3f& point, double range_m, Bin& bin) {
  constexpr double sigmas = 2.0;
  const auto z = static_cast<double>(point.z());
  const double sigma_m = config.sigma_by_square_1_m * config.range_m * config.range_m;
  if (z >= config.slice_from_m && z <= config.body_height_m && range_m > config.range_m + sigmas * sigma_m)
    ++bin.past;
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

/// Returns where the surface stands whose front a range belongs to: the mean of what returned as far behind it as
/// depth may be off. The front alone is nearer than the surface, by more the more points there are.
double surface_m(const std::vector<float>& ranges, double front_m, double sigma_m) {
  constexpr double sigmas_before = 1.0;
  constexpr double sigmas_behind = 3.0;
  double sum_m = 0.0;
  double count = 0.0;
  for (const float range : ranges) {
    const double behind_m = static_cast<double>(range) - front_m;
    if (behind_m < -sigmas_before * sigma_m || behind_m > sigmas_behind * sigma_m) continue;
    sum_m += static_cast<double>(range);
    count += 1.0;
  }
  return count > 0.0 ? sum_m / count : front_m;
}

Beam beam_of(const PseudoScanConfig& config, Bin& bin, double bearing_rad) {
  Beam beam;
  beam.bearing_rad = bearing_rad;
  const double floor_m = floor_seen_m(config, bin.floor);
  const auto rank = static_cast<std::ptrdiff_t>(config.rank);
  if (static_cast<std::ptrdiff_t>(bin.slice.size()) >= rank) {
    std::nth_element(bin.slice.begin(), bin.slice.begin() + (rank - 1), bin.slice.end());
    beam.kind = Beam::Return::obstacle;
    const auto front_m = static_cast<double>(bin.slice[static_cast<std::size_t>(rank - 1)]);
    beam.sigma_m = config.sigma_by_square_1_m * front_m * front_m;
    beam.range_m = surface_m(bin.slice, front_m, beam.sigma_m);
    const bool may_fall = bin.has_drop && static_cast<double>(bin.drop_m) < front_m;
    beam.clear_m = may_fall ? std::min(floor_m, front_m) : front_m;
    return beam;
  }
  if (bin.past >= config.rank && !bin.has_drop) {
    beam.clear_m = config.range_m;
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

Eigen::Vector2d end_of(const Beam& beam) {
  return beam.range_m * Eigen::Vector2d(std::cos(beam.bearing_rad), std::sin(beam.bearing_rad));
}

/// Returns whether most beams beside one end where it does.
bool ends_on_a_line(const PseudoScanConfig& config, const std::vector<Beam>& beams, std::size_t at) {
  constexpr std::size_t beside = 3;
  constexpr int least = 4;
  int near = 0;
  for (std::size_t i = at > beside ? at - beside : 0; i <= at + beside && i < beams.size(); ++i) {
    if (i == at || beams[i].kind == Beam::Return::none) continue;
    if ((end_of(beams[i]) - end_of(beams[at])).norm() <= config.edge_step_m) ++near;
  }
  return near >= least;
}

/// Takes back the ends of floor that are no foot of a wall: a floor whose texture fades ends raggedly.
void drop_ragged_edges(const PseudoScanConfig& config, std::vector<Beam>& beams) {
  std::vector<std::size_t> ragged;
  for (std::size_t i = 0; i < beams.size(); ++i)
    if (beams[i].kind == Beam::Return::floor_edge && !ends_on_a_line(config, beams, i)) ragged.push_back(i);
  for (const std::size_t i : ragged) {
    beams[i].kind = Beam::Return::none;
    beams[i].range_m = beams[i].sigma_m = 0.0;
  }
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
  in("past_m", config.past_m, Low::closed, 0, 100);
  in("clear_from_m", config.clear_from_m, Low::closed, 0, 5);
  in("floor_m", config.floor_m, Low::open, 0, config.slice_from_m);
  in("floor_from_m", config.floor_from_m, Low::open, 0, 5);
  in("floor_gap_m", config.floor_gap_m, Low::open, 0, 2);
  in("edge_sigma_m", config.edge_sigma_m, Low::open, 0, 2);
  in("edge_step_m", config.edge_step_m, Low::open, 0, 2);
  in("sigma_by_square_1_m", config.sigma_by_square_1_m, Low::closed, 0, 1);
  return std::move(out.issues);
}

Scan pseudo_scan(const PseudoScanConfig& config, std::span<const Eigen::Vector3f> level_points,
                 const Pose2& robot_from_scan) {
  const auto count = static_cast<std::size_t>(std::max(1.0, std::ceil(config.field_of_view_rad / config.bin_rad)));
  const double right_rad = -0.5 * static_cast<double>(count) * config.bin_rad;
  const double most_m = std::max(config.range_m, config.past_m);
  std::vector<Bin> bins(count);
  for (const Eigen::Vector3f& point : level_points) {
    const float range = std::hypot(point.x(), point.y());
    if (!(static_cast<double>(range) <= most_m) || !std::isfinite(point.z())) continue;
    const double bearing = std::atan2(static_cast<double>(point.y()), static_cast<double>(point.x()));
    const double at = std::floor((bearing - right_rad) / config.bin_rad);
    if (at < 0.0 || at >= static_cast<double>(count)) continue;
    Bin& bin = bins[static_cast<std::size_t>(at)];
    if (static_cast<double>(range) <= config.range_m) {
      put(config, point, range, bin);
    } else {
      put_past(config, point, static_cast<double>(range), bin);
    }
  }
  Scan scan{robot_from_scan, {}, config.clear_from_m};
  scan.beams.reserve(count);
  for (std::size_t i = 0; i < count; ++i)
    scan.beams.push_back(beam_of(config, bins[i], right_rad + (static_cast<double>(i) + 0.5) * config.bin_rad));
  drop_ragged_edges(config, scan.beams);
  return scan;
}

}  // namespace weft::agents
