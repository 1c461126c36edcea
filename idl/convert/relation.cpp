#include "idl/convert/common.hpp"

namespace weft::convert {
namespace {

constexpr std::uint8_t kMetric2 = 1;
constexpr std::uint8_t kMetric3 = 2;
constexpr std::uint8_t kAlongPath = 3;

template <class Matrix>
std::vector<double> row_by_row(const Matrix& matrix) {
  std::vector<double> values;
  values.reserve(static_cast<std::size_t>(matrix.size()));
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column) values.push_back(matrix(row, column));
  }
  return values;
}

template <class Matrix>
Matrix matrix_from(const std::vector<double>& values) {
  Matrix matrix;
  std::size_t at = 0;
  for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column) matrix(row, column) = values[at++];
  }
  return matrix;
}

idl::Relation packed(std::uint8_t kind, std::vector<double> mean, std::vector<double> covariance) {
  idl::Relation wire;
  wire.kind(kind);
  wire.mean(std::move(mean));
  wire.covariance(std::move(covariance));
  return wire;
}

struct Pack {
  idl::Relation operator()(const Metric2& metric) const {
    return packed(kMetric2, {metric.a_from_b.x, metric.a_from_b.y, metric.a_from_b.heading},
                  row_by_row(metric.covariance));
  }
  idl::Relation operator()(const Metric3& metric) const {
    const Eigen::Vector3d& t = metric.a_from_b.translation;
    const Eigen::Quaterniond& q = metric.a_from_b.rotation;
    return packed(kMetric3, {t.x(), t.y(), t.z(), q.x(), q.y(), q.z(), q.w()},
                  row_by_row(metric.covariance.matrix()));
  }
  idl::Relation operator()(const AlongPath& along) const {
    return packed(kAlongPath, {along.distance_m, along.heading_shift_rad},
                  {along.distance_variance_m2, along.heading_variance_rad2});
  }
};

Relation unpacked(const idl::Relation& wire) {
  const std::vector<double>& mean = wire.mean();
  if (wire.kind() == kMetric2) {
    return Metric2{{mean[0], mean[1], mean[2]}, matrix_from<Eigen::Matrix3d>(wire.covariance())};
  }
  if (wire.kind() == kMetric3) {
    const Eigen::Quaterniond rotation(mean[6], mean[3], mean[4], mean[5]);
    return Metric3{{rotation, {mean[0], mean[1], mean[2]}}, matrix_from<Matrix6d>(wire.covariance())};
  }
  return AlongPath{mean[0], wire.covariance()[0], mean[1], wire.covariance()[1]};
}

}  // namespace

void describe(Writing& /*io*/, const Relation& value, idl::Relation& wire) {
  wire = std::visit(Pack{}, value);
}

void describe(Reading& io, Relation& value, const idl::Relation& wire) {
  struct Sizes {
    std::size_t mean, covariance;
  };
  constexpr Sizes kSizes[] = {{3, 9}, {7, 36}, {2, 2}};
  if (wire.kind() < kMetric2 || wire.kind() > kAlongPath) return io.complain("kind", "must be from 1 to 3");
  const Sizes expected = kSizes[wire.kind() - 1];
  if (wire.mean().size() != expected.mean || wire.covariance().size() != expected.covariance) {
    return io.complain("mean and covariance", "must have the sizes of the relation's kind");
  }
  value = unpacked(wire);
  if (const Result<void> checked = check(value); !checked) io.complain("relation", checked.error().message);
}

}  // namespace weft::convert
