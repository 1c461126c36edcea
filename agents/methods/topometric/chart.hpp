#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "agents/control/grid/occupancy_grid.hpp"
#include "agents/control/grid/ray_cast.hpp"
#include "agents/methods/method.hpp"
#include "agents/methods/topometric/content.hpp"
#include "agents/perception/particles/likelihood_field.hpp"
#include "agents/perception/particles/resampling.hpp"
#include "core/geometry/pose2.hpp"
#include "core/ids.hpp"
#include "core/random.hpp"

namespace weft::agents {

/// Bounds what a chart is made of, and how large its grid is. Dayoub et al. (2013, III-A; ERRATA: metres) make 10 x
/// 10 m of the nodes within 4 x 4 m and stop the robot to switch. Here it drives on while charts change, up to 3 m
/// and a hop from the centre, and looks 5 m ahead: the grid reaches so far, and clouds come from as far as the chart
/// has places, as the way back is known by those that lie beyond it and look this way.
struct TopometricChartConfig {
  double side_m = 16.0;        ///< of the grid; [4, 40]
  double cell_m = 0.05;        ///< [0.02, 0.25]
  double within_m = 6.0;       ///< places count in a square that reaches so far from the centre; (0, 20]
  double apart_m = 0.7;        ///< of places nearer to each other than this that look the same way one counts; [0, 5]
  double apart_rad = 0.35;     ///< up to so much they look the same way; [0, pi]
  int most_clouds = 24;        ///< nearest to the centre first; [1, 200]
  double seen_within_m = 3.5;  ///< points farther from their camera are not cast; (0, 100]
  /// Is the share of a cell's rays that has to end there for it to be occupied. Walls along a way are met at low
  /// angles, and most rays that end in such a wall's next cells have passed this one. (0, 1]
  double tau = 0.12;
  /// Takes a beam that ends in an unknown cell this near to an occupied one for one that ends there: behind the face
  /// of a wall nothing is known. [0, 1]
  double behind_m = 0.1;
  /// Frees what nobody has seen so far around where the robots stood that taught the places: a camera that looks
  /// ahead does not see the floor under it. The paper has no such rule; its robot was driven both ways. [0, 1]
  double driven_m = 0.4;
};

/// Describes a place of a chart.
struct TopometricPlace {
  PlaceId id;
  Pose2 centre_from_place;
  std::shared_ptr<const TopometricContent> content;  ///< null: it has not arrived
};
using TopometricPlaces = std::vector<TopometricPlace>;

/// Holds what is known around a place: the places there, and what their clouds show from above, all in the frame of
/// the centre. Read-only once made.
struct TopometricChart {
  std::shared_ptr<const TopometricPlaces> places;  ///< never null
  OccupancyGrid grid;
  LikelihoodField field;
  std::vector<std::uint32_t> free_cells;  ///< by index

  const TopometricPlace* find(const PlaceId& id) const;
  /// Returns the place nearest to a point, of those that `counts` accepts; null: none.
  template <class Counts>
  const TopometricPlace* nearest(const Eigen::Vector2d& in_centre, const Counts& counts) const {
    const TopometricPlace* found = nullptr;
    for (const TopometricPlace& place : *places) {
      if (!counts(place)) continue;
      const auto apart_m = [&](const TopometricPlace& one) {
        return (one.centre_from_place.translation() - in_centre).squaredNorm();
      };
      if (found == nullptr || apart_m(place) < apart_m(*found)) found = &place;
    }
    return found;
  }
  /// Returns what draws poses of free cells, whatever the heading; empty where no cell is free. The chart outlives
  /// it.
  DrawPose anywhere_free() const;
};

/// Makes a chart of the places around a centre; those without content leave their cells unknown. Rays begin where the
/// camera of each frame was.
TopometricChart chart_places(const TopometricChartConfig& config, const RayCastConfig& rays,
                             const LikelihoodConfig& likelihood,
                             const std::vector<ChartPlace<TopometricContent>>& around);

}  // namespace weft::agents
