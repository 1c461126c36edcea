#pragma once
#include <cstdint>
#include <vector>

#include "agents/control/grid/ray_cast.hpp"
#include "agents/methods/topometric/content.hpp"
#include "agents/perception/scan.hpp"
#include "core/geometry/pose3.hpp"

namespace weft::agents {

/// Returns the points of a place's cloud as rays are cast to them, in another level frame.
SeenCloud seen_cloud(const PlaceCloud& cloud, const Pose3& frame_from_place);

/// Marks the 64 equal parts of what a camera sees in which every beam is clear as far as `clear_m`; the lowest bit is
/// the one farthest right.
std::uint64_t clear_bearings(const Scan& scan, const StereoRig& rig, double clear_m);

/// Adds rays over the floor to a place's cloud that is seen in another frame: as far as its frames saw nothing stand.
/// They end no farther apart than cells of the grid. Between two lanes side by side little else tells what is free: a
/// pair's points within range lie on walls that it drives past, and a floor's texture fades.
void add_clear_rays(const TopometricContent& content, const Pose3& frame_from_place, const RayCastConfig& config,
                    double cell_m, SeenCloud& seen);

/// Holds which points of a cloud stand where another place has seen nothing.
struct StandingInFree {
  double share = 0.0;                  ///< of those that were compared; 0: too few were
  std::vector<std::uint8_t> is_point;  ///< by number of the point; 1: it stands there
};

/// Finds b's points, of those that stand above the floor no higher than the robot and that lie where a knows the
/// cells, that lie in the middle of cells which a's rays have passed, as deep in it as their depth may be off by
/// `noise`: two views of one place hardly have any, unless something has come or gone.
StandingInFree standing_in_free(const PlaceCloud& a, const PlaceCloud& b, const Pose3& a_from_b,
                                const RayCastConfig& config, const DepthNoise& noise);

}  // namespace weft::agents
