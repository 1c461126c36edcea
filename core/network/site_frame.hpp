#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "core/geometry/pose2.hpp"
#include "core/result.hpp"

namespace weft {

/// Describes a point that somebody has found on a floor plan. All of a plan's picks lie in one layout: a frame in
/// which every place of a connected part of the network has a pose.
struct SitePick {
  std::string name;  ///< for people: "dock-2"
  Pose2 layout_from_place;
  Eigen::Vector2d in_place = Eigen::Vector2d::Zero();  ///< the point in the place's frame, metres
  Eigen::Vector2d on_plan = Eigen::Vector2d::Zero();   ///< metres
  std::optional<double> heading;                       ///< of the place on the plan, radians
  double sigma_m = 0.05;                               ///< [0.001, 10] of the point on the plan, each way
};

/// Tells where a layout lies on a floor plan.
struct SiteFrame {
  Pose2 plan_from_layout;
  double scale = 1.0;                 ///< metres of the plan for one of the layout, which fit best; never applied
  std::vector<double> off_m;          ///< by pick: how far it lies from where it was picked; of those left out too
  std::vector<std::size_t> left_out;  ///< picks that contradict all others, the worst first
  double sigma_m = 0.0;               ///< of the position in the middle of the picks
  std::optional<double> sigma_rad;    ///< of the heading; none: it was stated by picks
};

/// Fits the rotation and translation that bring the picks closest to their points on the plan: Umeyama 1991 in the
/// plane, weighted by 1 / sigma^2 and without scale. One pick, or several within a metre, need a heading. Of four or
/// more, one that lies further than four sigma from where the others say is left out, and so on while three are left;
/// `sigma` is the pick's, the spread of the others and how surely these foretell it together. invalid: no pick, none
/// two of which lie `kPicksApart_m` apart and none with a heading, or a sigma out of its bound.
Result<SiteFrame> fit_site_frame(const std::vector<SitePick>& picks);

inline constexpr double kPicksApart_m = 1.0;

}  // namespace weft
