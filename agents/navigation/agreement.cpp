#include "agents/navigation/agreement.hpp"

#include <algorithm>
#include <cmath>

namespace weft::agents {

Spread spread_of(const Relation& relation) {
  const Eigen::Matrix3d covariance = planar_covariance(relation);
  return {std::sqrt(std::max(covariance(0, 0), covariance(1, 1))), std::sqrt(covariance(2, 2))};
}

std::optional<Refusal> agreement(const Relation& predicted, const Relation& measured, double within_m,
                                 double within_rad) {
  const Pose2 apart = planar(predicted).inverse() * planar(measured);
  const double metres = apart.translation().norm();
  if (metres > within_m) return Refusal{"stitch_disagrees", metres, within_m};
  const double radians = std::abs(wrap_angle(apart.heading));
  if (radians > within_rad) return Refusal{"stitch_disagrees_in_heading", radians, within_rad};
  return std::nullopt;
}

}  // namespace weft::agents
