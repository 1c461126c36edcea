#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "core/geometry/pose2.hpp"

/// Holds poses in the plane against others; both lists are of the same moments. All pure.
namespace weft::evaluate::ceiling {

/// Describes where poses of a frame b lie in a frame a, by the least squares over all positions (Umeyama 1991).
struct Alignment {
  Pose2 a_from_b;
  double scale = 1.0;  ///< of b's metres in a, where it was fitted
  double rms_m = 0.0;  ///< what is left
};
/// Fits no scale: a wrong one shows in what is left. Both lists have as many, at least two.
Alignment aligned(const std::vector<Pose2>& in_a, const std::vector<Pose2>& in_b);
/// Fits a scale as well.
Alignment aligned_with_scale(const std::vector<Pose2>& in_a, const std::vector<Pose2>& in_b);

/// Returns poses of b laid in a, their headings turned by the mean difference: the two may be of frames that are
/// mounted otherwise on one robot.
std::vector<Pose2> laid_in_a(const std::vector<Pose2>& in_a, const std::vector<Pose2>& in_b);

/// Returns the RMS of the differences of the headings, radians.
double heading_rms_rad(const std::vector<Pose2>& one, const std::vector<Pose2>& other);

/// Returns whether what is said of a relation is off by more than so much.
bool is_off(const Pose2& said, const Pose2& truth, double metres, double radians);

}  // namespace weft::evaluate::ceiling
