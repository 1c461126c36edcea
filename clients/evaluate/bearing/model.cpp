#include "clients/evaluate/bearing/model.hpp"

#include <algorithm>
#include <cmath>

namespace weft::evaluate::bearing {
namespace {

constexpr double kStepM = 0.02;

double error_at(const std::vector<ErrorAt>& errors, double along_m) {
  const auto after =
      std::find_if(errors.begin(), errors.end(), [&](const ErrorAt& error) { return error.along_m >= along_m; });
  if (after == errors.begin()) return after->error_m;
  if (after == errors.end()) return errors.back().error_m;
  const ErrorAt& before = *(after - 1);
  const double share = (along_m - before.along_m) / (after->along_m - before.along_m);
  return before.error_m + share * (after->error_m - before.error_m);
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

std::vector<double> unwrapped(const std::vector<double>& along_m, double round_m) {
  std::vector<double> all;
  double before_m = 0.0;
  for (const double here_m : along_m) {
    before_m = here_m + round_m * std::round((before_m - here_m) / round_m);
    all.push_back(before_m);
  }
  return all;
}

std::vector<ErrorAt> first_loop_of(const Repeated& repeated, const Course& course) {
  std::vector<double> along_m;
  for (const Deviation& deviation : repeated.along) along_m.push_back(deviation.along_m);
  along_m = unwrapped(along_m, course.round_m());
  std::vector<ErrorAt> errors;
  for (std::size_t i = 0; i < along_m.size() && along_m[i] <= course.length_m; ++i)
    errors.push_back({along_m[i], repeated.along[i].path_from_robot.translation().norm()});
  return errors;
}

double band_of(const std::vector<ErrorAt>& driven, const std::vector<ErrorAt>& model) {
  double band = 0.0;
  for (const ErrorAt& error : driven) band = std::max(band, std::abs(error.error_m - error_at(model, error.along_m)));
  return band;
}

}  // namespace weft::evaluate::bearing
