#include "agents/bodies/sim/hall/exposure_control.hpp"

#include <algorithm>

namespace weft::agents::sim {

ExposureControl::ExposureControl(const ForwardCameraSetup& setup, double exposure_s)
    : setup_(setup), nominal_s_(exposure_s) {}

double ExposureControl::exposure_s() const {
  return std::min(nominal_s_ * asked_, setup_.longest_exposure_s);
}

double ExposureControl::amplified() const {
  return nominal_s_ <= 0.0 ? std::max(1.0, asked_) : std::max(1.0, nominal_s_ * asked_ / setup_.longest_exposure_s);
}

void ExposureControl::taken(double mean_light) {
  if (!setup_.exposes_itself) return;
  constexpr double followed = 0.35;  // of what is missing, an image
  constexpr double least = 0.02;
  const double wanted = setup_.mean_grey / std::max(1.0, mean_light);
  asked_ = std::clamp(asked_ + followed * (wanted - asked_), least, setup_.most_gain);
}

}  // namespace weft::agents::sim
