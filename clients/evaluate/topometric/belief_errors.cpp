#include "clients/evaluate/topometric/belief_errors.hpp"

#include <Eigen/LU>
#include <cmath>

#include "clients/evaluate/topometric/spread.hpp"

namespace weft::evaluate::topometric {
namespace {

using agents::Following;
using agents::Twist;

constexpr double kChiSquare95Of3 = 7.815;
constexpr double kAroundSwitchS = 1.0;
constexpr double kSetsOutS = 2.0;  // a robot that sets out stands before it drives, whatever charts do

/// Returns the truth in the frame of what is believed. None: the place is nobody's.
std::optional<Pose2> believed_from_truth(const BelievedAt& believed, const Pose2& site_from_robot,
                                         const TruePlaces& places) {
  const auto place = places.find(believed.place);
  if (place == places.end()) return std::nullopt;
  return believed.place_from_robot.inverse() * place->second.inverse() * site_from_robot;
}

bool is_on_its_way(const Moment& moment) {
  return moment.following == Following::driving || moment.following == Following::waiting ||
         moment.following == Following::stopped;
}

/// Returns whether the robot has been on its way for a while at that moment.
bool has_set_out(const Moments& moments, std::size_t at) {
  for (std::size_t i = at; moments[at].sensor_s - moments[i].sensor_s < kSetsOutS; --i) {
    if (!is_on_its_way(moments[i])) return false;
    if (i == 0) return false;
  }
  return true;
}

}  // namespace

BeliefErrors belief_errors(const Moments& moments, const TruePlaces& places) {
  BeliefErrors errors;
  for (const Moment& moment : moments) {
    if (!moment.believed || moment.lost) continue;
    const std::optional<Pose2> off = believed_from_truth(*moment.believed, moment.site_from_robot, places);
    if (!off) continue;
    errors.metres.push_back(off->translation().norm());
    errors.radians.push_back(std::abs(off->heading));
  }
  return errors;
}

FixErrors fix_errors(const Moments& moments, const TruePlaces& places) {
  std::vector<double> distances2;
  double held = 0.0;
  for (const Moment& moment : moments) {
    if (!moment.fix) continue;
    const std::optional<Pose2> off = believed_from_truth(*moment.fix, moment.site_from_robot, places);
    if (!off) continue;
    const Eigen::Vector3d xi = se2_log(*off);
    distances2.push_back(xi.dot(moment.fix->covariance.inverse() * xi));
    held += distances2.back() <= kChiSquare95Of3 ? 1.0 : 0.0;
  }
  return {percent_of(held, static_cast<double>(distances2.size())), mean_of(distances2)};
}

SwitchErrors switch_errors(const Moments& moments) {
  SwitchErrors errors;
  for (std::size_t at = 0; at < moments.size(); ++at) {
    const Moment& now = moments[at];
    if (!now.has_switched || std::isnan(now.jump_m) || !has_set_out(moments, at)) continue;
    errors.jumps_m.push_back(now.jump_m);
    double stood_s = 0.0;
    for (std::size_t i = 1; i < moments.size(); ++i) {
      if (std::abs(moments[i].sensor_s - now.sensor_s) > kAroundSwitchS || !is_on_its_way(moments[i])) continue;
      if (moments[i].command == Twist{}) stood_s += moments[i].sensor_s - moments[i - 1].sensor_s;
    }
    errors.stands_s.push_back(stood_s);
  }
  return errors;
}

bool is_believed_right(const BelievedAt& believed, const Pose2& site_from_robot, const TruePlaces& places,
                       double metres, double radians) {
  const std::optional<Pose2> off = believed_from_truth(believed, site_from_robot, places);
  return off && off->translation().norm() <= metres && std::abs(off->heading) <= radians;
}

}  // namespace weft::evaluate::topometric
