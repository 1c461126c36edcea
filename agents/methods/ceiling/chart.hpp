#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "agents/methods/ceiling/config.hpp"
#include "agents/methods/ceiling/content.hpp"
#include "agents/methods/method.hpp"

namespace weft::agents {

/// Describes a corner of a chart, where all places that show it have it together.
struct ChartCorner {
  PlaneFeature feature;         ///< level, in the frame of the chart's centre
  double information_m2 = 0.0;  ///< 1 over the variance of its place, each way
  std::uint32_t places = 0;     ///< so many show it
};

/// Describes a place of a chart.
struct ChartedCeiling {
  PlaceId id;
  Pose2 centre_from_place;
  std::shared_ptr<const CeilingContent> content;  ///< null while its bytes have not arrived
};

/// Holds the mosaic of the ceiling around a place, made of features in place of pixels (Lucas et al., II.D): what
/// places show is laid into the frame of the centre, and what several show is one corner.
struct CeilingChart {
  double ceiling_m = 0.0;  ///< of the first place with a content, to which all others are brought
  std::vector<ChartedCeiling> places;
  std::vector<ChartCorner> corners;

  /// Returns the place with that id; null: it is none of the chart's.
  const ChartedCeiling* find(const PlaceId& id) const;
  /// Returns the place with a content that is nearest to a point of the centre's frame; null: none has one.
  const ChartedCeiling* nearest(const Eigen::Vector2d& in_centre) const;
  /// Returns the corners within `reach_m` of a point of the centre's frame, those of most places first, at most so
  /// many, in the frame of a place.
  std::vector<PlaneFeature> around(const Eigen::Vector2d& in_centre, double reach_m, std::size_t most,
                                   const Pose2& centre_from_place) const;
};

/// Lays out the mosaic. Places whose ceiling is another one, or that are at no known pose, lend no corners.
CeilingChart chart_ceiling(const CeilingConfig& config, const std::vector<ChartPlace<CeilingContent>>& around);

}  // namespace weft::agents
