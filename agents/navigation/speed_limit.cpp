#include "agents/navigation/speed_limit.hpp"

#include <algorithm>
#include <cmath>

namespace weft::agents {

double speed_limit(const FollowConfig& config, const Estimate& estimate) {
  const double left_m = config.blind_limit_m - estimate.blind_m;
  const double by_blindness = left_m / (config.blind_limit_m - config.sure_m);
  const Eigen::Matrix3d covariance = planar_covariance(estimate.place_from_robot);
  const double sigma_m = std::sqrt(std::max({covariance(0, 0), covariance(1, 1), 0.0}));
  const double by_sigma = sigma_m > config.sure_sigma_m ? config.sure_sigma_m / sigma_m : 1.0;
  return config.speed_m_s * std::clamp(std::min(by_blindness, by_sigma), config.unsure_share, 1.0);
}

}  // namespace weft::agents
