#pragma once
#include <Eigen/Core>
#include <span>
#include <vector>

#include "agents/perception/scan.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Bounds what of a cloud becomes a scan (Dayoub et al. 2013, III-B: a horizontal slice, its closest points).
struct PseudoScanConfig {
  double slice_from_m = 0.12;      ///< above the floor; (0, 1]
  double body_height_m = 1.5;      ///< the slice ends here; (slice_from_m, 5]
  double bin_rad = 0.0087266;      ///< 0.5 degrees; (0, 0.2]
  double field_of_view_rad = 1.4;  ///< about straight ahead; (0, 2 pi]
  int rank = 3;                    ///< the so many closest point of a bin is a front: closer ones may fly; [1, 20]
  double range_m = 5.0;            ///< farther points are no returns; (0, 100]
  double past_m = 10.0;            ///< but up to here show that nothing stands before them; [0, 100]
  double clear_from_m = 0.0;       ///< rays tell nothing of what stands nearer: Scan::clear_from_m; [0, 5]
  double floor_m = 0.06;           ///< a point this near to z = 0 is floor; (0, slice_from_m]
  double floor_from_m = 1.2;       ///< the floor must be seen from here on, nearer it is out of view; (0, 5]
  double floor_gap_m = 0.25;       ///< a longer stretch without floor ends what was seen of it; (0, 2]
  double edge_sigma_m = 0.25;      ///< of a floor's far edge taken for a wall; (0, 2]
  double edge_step_m = 0.15;       ///< by which it may differ from beam to beam to be taken so; (0, 2]
  /// Scales the standard deviation of a range, z^2 times this: sigma of the disparity over focal length and baseline,
  /// 1/m. [0, 1]
  double sigma_by_square_1_m = 0.01;
};
/// Returns every bound that does not hold, each error naming field, value and bound.
std::vector<Error> check(const PseudoScanConfig& config);

/// Makes a scan of a cloud in the levelled frame of a sensor's foot: x ahead, y left, z above the floor. A bearing is
/// clear up to the front of what stands there, and returns where that stands, as far as depth noise lets the two
/// differ. A bearing without a return is clear only as far as floor was seen on it without a gap, never because
/// nothing was seen; of one with points below the floor, too, no more than that is clear: there is a drop. One
/// without either, but with as many points surely farther off than range_m as a return takes, is clear up to range_m.
/// Points that are not finite are left out.
Scan pseudo_scan(const PseudoScanConfig& config, std::span<const Eigen::Vector3f> level_points,
                 const Pose2& robot_from_scan);

}  // namespace weft::agents
