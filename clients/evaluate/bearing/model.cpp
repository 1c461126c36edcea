#include "clients/evaluate/bearing/model.hpp"

#include <algorithm>
#include <cmath>

namespace weft::evaluate::bearing {
namespace {

constexpr double kStepM = 0.02;

double error_at(const std::vector<ErrorAt>& errors, double along_m) {
  const auto after =
      std::find_if(errors.begin(), errors.end(), [&](const ErrorAt& error) { return error.along_m >= along_m; });
  return after == errors.end() ? errors.back().error_m : after->error_m;
}

}  // namespace

std::vector<ErrorAt> modelled(const Course& course, const Eigen::Vector2d& first, double landmark_m) {
  std::vector<ErrorAt> errors = {{0.0, first.norm()}};
  Eigen::Vector2d error = first;
  for (std::size_t i = 0; i + 1 < course.places.size(); ++i) {
    const double hop_m = distance_m(course.relations[i]);
    const double turn_rad = heading_rad(course.relations[i]);
    const int steps = std::max(1, static_cast<int>(std::ceil(hop_m / kStepM)));
    for (int step = 0; step < steps; ++step) {
      const double way_m = hop_m / steps;
      // By the way instead of by time: both sides divided by v.
      const double turned = turn_rad / steps;
      error += Eigen::Vector2d(turned * error.y(), -turned * error.x() - way_m / landmark_m * error.y());
    }
    errors.push_back({course.along_m[i + 1], error.norm()});
  }
  return errors;
}

std::vector<ErrorAt> first_loop_of(const Repeated& repeated, const Course& course) {
  std::vector<ErrorAt> errors;
  for (const Deviation& deviation : repeated.along) {
    const bool is_over = !repeated.after_loop.empty() && deviation.driven_m >= repeated.after_loop.front().driven_m;
    if (is_over) break;
    // Just before the beginning it believes to be at the end.
    const bool is_before = deviation.along_m > 0.9 * course.length_m && errors.size() < 50;
    errors.push_back({is_before ? deviation.along_m - course.length_m : deviation.along_m,
                      deviation.path_from_robot.translation().norm()});
  }
  return errors;
}

double band_of(const std::vector<ErrorAt>& driven, const std::vector<ErrorAt>& model) {
  constexpr double turning_m = 1.0;
  double band = 0.0;
  for (const ErrorAt& error : driven) {
    if (error.along_m > turning_m) band = std::max(band, std::abs(error.error_m - error_at(model, error.along_m)));
  }
  return band;
}

}  // namespace weft::evaluate::bearing
