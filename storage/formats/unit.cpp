#include "storage/formats/unit.hpp"

#include <cmath>

namespace weft::formats {

std::optional<Eigen::Quaterniond> unit_quaternion(double w, double x, double y, double z) {
  constexpr double kLoosest = 1e-3;
  constexpr double kRounding = 1e-14;
  const Eigen::Quaterniond given(w, x, y, z);
  const double norm = given.norm();
  if (!(std::abs(norm - 1.0) <= kLoosest)) return std::nullopt;
  return std::abs(norm - 1.0) <= kRounding ? given : given.normalized();
}

}  // namespace weft::formats
