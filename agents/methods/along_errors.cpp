#include "agents/methods/along_errors.hpp"

#include <algorithm>
#include <cmath>

namespace weft::agents {

Step AlongErrors::improved(const Step& step) const {
  const auto* const told = std::get_if<AlongPath>(&step.previous_from_current);
  if (told == nullptr) return step;
  Step better = step;
  AlongPath moved = *told;
  const double ahead = step.common(0, 0);
  const double turned = step.common(kYaw, 1);
  moved.distance_m += ahead * distance_.value;
  moved.heading_shift_rad = wrap_angle(moved.heading_shift_rad + turned * turn_.value);
  moved.distance_variance_m2 = std::max(0.0, moved.distance_variance_m2 - ahead * ahead * (1.0 - distance_.variance));
  moved.heading_variance_rad2 = std::max(0.0, moved.heading_variance_rad2 - turned * turned * (1.0 - turn_.variance));
  better.previous_from_current = moved;
  better.common.col(0) *= std::sqrt(distance_.variance);
  better.common.col(1) *= std::sqrt(turn_.variance);
  return better;
}

void AlongErrors::Error::learn(double off, double known, double measured, double& part) {
  constexpr double least_variance = 1e-12;
  constexpr double never_surer = 0.01;  // wheels wear and floors differ
  const double spread = known + measured + least_variance;
  const double sigma = std::sqrt(variance);
  constexpr double most = 5.0;  // sigmas: fixes of the wrong place may not make wheels what none are
  value = std::clamp(value + sigma * part / spread * off, -most, most);
  variance = std::max(never_surer, variance * (1.0 - std::min(1.0, part * part / spread)));
  part *= (1.0 - known / spread) * sigma / std::sqrt(variance);
}

void AlongErrors::learn(const AlongPath& predicted, const AlongPath& measured, CommonErrors& common) {
  distance_.learn(measured.distance_m - predicted.distance_m, predicted.distance_variance_m2,
                  measured.distance_variance_m2, common(0, 0));
  turn_.learn(wrap_angle(measured.heading_shift_rad - predicted.heading_shift_rad), predicted.heading_variance_rad2,
              measured.heading_variance_rad2, common(kYaw, 1));
}

}  // namespace weft::agents
