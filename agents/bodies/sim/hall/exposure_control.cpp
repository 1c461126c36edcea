#include "agents/bodies/sim/hall/exposure_control.hpp"

#include <algorithm>

namespace weft::agents::sim {
namespace {

constexpr double kLeast = 0.02;  // of the exposure that sites are lit for
constexpr double kForgetsAfterS = 2.0;

}  // namespace

ExposureControl::ExposureControl(const ExposureSetup& setup, double exposure_s)
    : setup_(setup), nominal_s_(exposure_s) {}

/// Returns the exposure time, s, that the site is lit for. A camera whose images are not to blur has images as light
/// as those of one that takes as long as others.
double ExposureControl::lit_for_s() const {
  return nominal_s_ > 0.0 ? nominal_s_ : Disturbances{}.exposure_s;
}

void ExposureControl::comes(double time_s) {
  now_s_ = time_s;
  if (!told_ || now_s_ - told_at_s_ <= kForgetsAfterS) return;
  asked_ = gain();
  told_.reset();
}

double ExposureControl::exposure_s() const {
  if (nominal_s_ <= 0.0) return 0.0;
  return told_ ? told_->time_s : std::min(nominal_s_ * asked_, setup_.longest_exposure_s);
}

double ExposureControl::amplified() const {
  if (told_) return told_->gain;
  return nominal_s_ <= 0.0 ? std::max(1.0, asked_) : std::max(1.0, nominal_s_ * asked_ / setup_.longest_exposure_s);
}

Exposure ExposureControl::now() const {
  if (told_) return *told_;
  return {lit_for_s() * asked_ / amplified(), amplified()};
}

void ExposureControl::taken(double mean_light) {
  if (!setup_.exposes_itself || told_) return;
  constexpr double followed = 0.35;  // of what is missing, an image
  const double wanted = setup_.mean_grey / std::max(1.0, mean_light);
  asked_ = std::clamp(asked_ + followed * (wanted - asked_), kLeast, setup_.most_gain);
}

bool ExposureControl::tell(const Exposure& exposure) {
  if (!setup_.exposes_itself) return false;
  const double light_s = std::clamp(exposure.light_s(), kLeast * lit_for_s(), setup_.most_gain * lit_for_s());
  const double time_s = std::clamp(exposure.time_s, kLeast * lit_for_s(), setup_.longest_exposure_s);
  told_ = Exposure{std::min(time_s, light_s), std::max(1.0, light_s / time_s)};
  told_at_s_ = now_s_;
  return true;
}

}  // namespace weft::agents::sim
