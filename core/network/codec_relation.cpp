#include "core/network/codec.hpp"
#include "core/network/fields.hpp"

namespace weft {
namespace {

constexpr std::uint8_t kMetric2 = 1;
constexpr std::uint8_t kMetric3 = 2;
constexpr std::uint8_t kAlongPath = 3;

/// Writes the lower triangle, row by row: the half that `check` looks at.
template <class Matrix>
void write_symmetric(ByteWriter& out, const Matrix& matrix) {
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (Eigen::Index column = 0; column <= row; ++column) out.f64(matrix(row, column));
  }
}

template <class Matrix>
void read_symmetric(ByteReader& in, Matrix& matrix) {
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (Eigen::Index column = 0; column <= row; ++column) {
      matrix(row, column) = matrix(column, row) = in.f64("covariance");
    }
  }
}

Metric2 read_metric2(ByteReader& in) {
  Metric2 metric;
  metric.a_from_b.x = in.f64("x");
  metric.a_from_b.y = in.f64("y");
  metric.a_from_b.heading = in.f64("heading");
  read_symmetric(in, metric.covariance);
  return metric;
}

Metric3 read_metric3(ByteReader& in) {
  Metric3 metric;
  for (double& axis : metric.a_from_b.translation) axis = in.f64("translation");
  const double w = in.f64("rotation w");
  const double x = in.f64("rotation x");
  const double y = in.f64("rotation y");
  const double z = in.f64("rotation z");
  metric.a_from_b.rotation = Eigen::Quaterniond(w, x, y, z);
  Matrix6d covariance;
  read_symmetric(in, covariance);
  metric.covariance = covariance;
  return metric;
}

AlongPath read_along_path(ByteReader& in) {
  AlongPath path;
  path.distance_m = in.f64("distance");
  path.distance_variance_m2 = in.f64("distance variance");
  path.heading_shift_rad = in.f64("heading shift");
  path.heading_variance_rad2 = in.f64("heading variance");
  return path;
}

}  // namespace

void fields::write(ByteWriter& out, const Relation& relation) {
  if (const auto* const flat = std::get_if<Metric2>(&relation)) {
    out.number<std::uint8_t>(kMetric2);
    for (const double value : {flat->a_from_b.x, flat->a_from_b.y, flat->a_from_b.heading}) out.f64(value);
    write_symmetric(out, flat->covariance);
  } else if (const auto* const metric = std::get_if<Metric3>(&relation)) {
    out.number<std::uint8_t>(kMetric3);
    for (const double axis : metric->a_from_b.translation) out.f64(axis);
    const Eigen::Quaterniond& q = metric->a_from_b.rotation;
    for (const double value : {q.w(), q.x(), q.y(), q.z()}) out.f64(value);
    write_symmetric(out, metric->covariance.matrix());
  } else {
    const auto& path = std::get<AlongPath>(relation);
    out.number<std::uint8_t>(kAlongPath);
    for (const double value :
         {path.distance_m, path.distance_variance_m2, path.heading_shift_rad, path.heading_variance_rad2}) {
      out.f64(value);
    }
  }
}

Relation fields::read_relation(ByteReader& in) {
  const std::size_t at = in.offset();
  Relation relation;
  switch (in.ranged<std::uint8_t>("relation kind", kMetric2, kAlongPath)) {
    case kMetric2:
      relation = read_metric2(in);
      break;
    case kMetric3:
      relation = read_metric3(in);
      break;
    default:
      relation = read_along_path(in);
  }
  if (!in.ok()) return {};
  const Result<void> checked = check(relation);
  if (!checked) in.corrupt("relation", at, "is none: " + checked.error().message);
  return relation;
}

Bytes encode(const Relation& relation) {
  return fields::record([&](ByteWriter& out) { fields::write(out, relation); });
}

Result<Relation> decode_relation(ByteView bytes) {
  return fields::whole<Relation>(bytes, "relation", fields::read_relation);
}

}  // namespace weft
