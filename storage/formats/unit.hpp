#pragma once
#include <Eigen/Geometry>
#include <optional>

namespace weft::formats {

/// Returns the unit quaternion that a file means; none when its norm is further than 1e-3 from 1. One that is unit to
/// the last bits stays as it is, so that what was written is read back the same.
std::optional<Eigen::Quaterniond> unit_quaternion(double w, double x, double y, double z);

}  // namespace weft::formats
