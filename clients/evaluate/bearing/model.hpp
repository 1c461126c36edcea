#pragma once
#include <vector>

#include "clients/evaluate/bearing/course.hpp"

namespace weft::evaluate::bearing {

/// Tells how far a robot that only corrects its heading is off after so much of the way.
struct ErrorAt {
  double along_m = 0.0;
  double error_m = 0.0;
};

/// Returns errors by the model of Krajnik et al. 2018, II, as corrected, without disturbances, along the taught way:
/// x' = omega y, y' = -omega x - (v / l) y, from `first` (x ahead, y left) on; l is how far away what is seen stands.
std::vector<ErrorAt> modelled(const Course& course, const Eigen::Vector2d& first, double landmark_m);

/// Turns distances along a closed way, one after the other, into distances that go on where the way closes. The first
/// one is about 0: what is believed to lie before the beginning is negative.
std::vector<double> unwrapped(const std::vector<double>& along_m, double round_m);

/// Returns the errors of the first loop as it was driven, as far as the taught way goes.
std::vector<ErrorAt> first_loop_of(const Repeated& repeated, const Course& course);

/// Returns the most by which the driven loop lies beside the model, in metres.
double band_of(const std::vector<ErrorAt>& driven, const std::vector<ErrorAt>& model);

/// Returns the median horizontal distance of what the robot's camera shows along the taught way.
Result<double> landmark_distance_m(const agents::sim::Site& site, const Course& course);

}  // namespace weft::evaluate::bearing
