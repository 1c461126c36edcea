#include "agents/bodies/sim/stance.hpp"

namespace weft::agents::sim {

Pose3 stance_on(const Relief& relief, const BaseSetup& base, const Pose2& site_from_robot) {
  const auto height_at = [&](double forward_m, double left_m) {
    const Eigen::Vector2d p = site_from_robot * Eigen::Vector2d(forward_m, left_m);
    return relief.height_m(p.x(), p.y());
  };
  const double before = height_at(base.radius_m, 0.0);
  const double behind = height_at(-base.radius_m, 0.0);
  const double left = height_at(0.0, base.track_m / 2);
  const double right = height_at(0.0, -base.track_m / 2);
  // Four points on a cross: the best fit's slopes are those along its two arms.
  const Eigen::Vector3d up_in_robot(-(before - behind) / (2 * base.radius_m), -(left - right) / base.track_m, 1.0);
  Pose3 site_from_body = lift(site_from_robot);
  site_from_body.translation.z() += (before + behind + left + right) / 4;
  const Eigen::Quaterniond tilt = Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), up_in_robot);
  site_from_body.rotation = (site_from_body.rotation * tilt).normalized();
  return site_from_body;
}

}  // namespace weft::agents::sim
