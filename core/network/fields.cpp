#include "core/network/fields.hpp"

#include <string>

#include "core/network/registration.hpp"

namespace weft {

double fields::read_within(ByteReader& in, const char* field, double least, double most) {
  const std::size_t at = in.offset();
  const double value = in.f64(field);
  if (!(value >= least && value <= most)) {
    in.corrupt(field, at, "is not from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return value;
}

void fields::write(ByteWriter& out, const Eigen::Vector2d& point) {
  out.f64(point.x());
  out.f64(point.y());
}

Eigen::Vector2d fields::read_point(ByteReader& in, const char* field) {
  const double x = read_within(in, field, -kPlanReach_m, kPlanReach_m);
  const double y = read_within(in, field, -kPlanReach_m, kPlanReach_m);
  return {x, y};
}

}  // namespace weft
