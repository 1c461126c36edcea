#include "agents/perception/clouds/ndt_cost.hpp"

#include <Eigen/LU>
#include <array>
#include <cmath>

// Everything is in frame b, where the pose's own xi is zero and a cell of a stands at c = R'(mean_a - t) with
// covariance A = R' S_a R, S_a that of its surface. A cell of b at p with S is moved to exp(xi) p. With q = p - c, B
// = (S + A)^-1, u = B q, s = S u the squared distance is d = q' u, its gradient 2 [u; (p - s) x u], and its second
// derivatives
//   2 K' B K + [0, [u]x; [u]x', u e' + e u' - 2 (u'e) I - 2 [u]x' S [u]x],  e = p - s,  K = [I, -[p]x + [s]x - S
//   [u]x].
// Derived anew from the second order of exp(xi): d counts S as it turns with b.
namespace weft::agents {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Matrix36d = Eigen::Matrix<double, 3, 6>;

constexpr double kLeastFactor = 0.01;  // pairs further apart count for nothing

Matrix3d crossing(const Vector3d& v) {
  Matrix3d matrix;
  matrix << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return matrix;
}

/// Describes a cell of a as b sees it.
struct Standing {
  Vector3d mean;
  Matrix3d covariance;
  double tilt_variance = 0.0;
  std::uint32_t number = 0;
};

std::vector<Standing> standing_in_b(const NdtLevel& a, const Pose3& b_from_a) {
  const Matrix3d rotation = b_from_a.rotation.toRotationMatrix();
  std::vector<Standing> all;
  all.reserve(a.cells.size());
  for (std::uint32_t number = 0; number < a.cells.size(); ++number) {
    const NdtCell& cell = a.cells[number];
    all.push_back({b_from_a * cell.mean, rotation * cell.surface * rotation.transpose(), cell.tilt_variance, number});
  }
  return all;
}

/// Finds the cells of a among the eight whose centres surround a point of a.
class Surrounding {
 public:
  Surrounding(const NdtLevel& a, const Vector3d& point_in_a) {
    const double per_m = 1.0 / a.cell_m;
    const Vector3d corner = point_in_a - a.origin - Vector3d::Constant(0.5 * a.cell_m);
    if (!is_on_grid(corner, per_m)) return;
    const CellCoordinates first = cell_of(corner, per_m);
    for (int at = 0; at < 8; ++at) {
      const std::uint32_t number =
          a.table.find({first[0] + (at & 1), first[1] + (at >> 1 & 1), first[2] + (at >> 2)});
      if (number != CellTable::kNone) numbers_[count_++] = number;
    }
  }
  std::span<const std::uint32_t> numbers() const { return {numbers_.data(), count_}; }

 private:
  std::array<std::uint32_t, 8> numbers_{};
  std::size_t count_ = 0;
};

/// Adds up the pairs of cells.
class PairSum {
  using Pull = Eigen::Matrix<double, 6, 3>;  // of a mean on the gradient

 public:
  PairSum(const NdtCostConfig& config, std::size_t cells_of_a, bool is_last)
      : config_(config),
        most_(-2.0 * std::log(kLeastFactor) / config.softness),
        pulls_(is_last ? cells_of_a : 0, Pull::Zero()) {}

  /// Begins the pairs of a cell of b.
  void begin(const NdtCell& b) {
    b_ = &b;
    pull_.setZero();
  }
  /// Adds a pair. Returns whether it counts.
  bool add(const Standing& a) {
    const Vector3d q = b_->mean - a.mean;
    const Matrix3d inverse = (b_->covariance + a.covariance).inverse();
    const Vector3d u = inverse * q;
    const double squared = q.dot(u);
    if (squared > most_) return false;
    add_derivatives(a, inverse, u, std::exp(-0.5 * config_.softness * squared));
    return true;
  }
  /// Ends the pairs of that cell.
  void end() {
    if (!pulls_.empty()) sum_.scatter += pull_ * b_->mean_covariance * pull_.transpose();
  }
  /// Returns the sum; the means of a's cells, which pairs share, are added last.
  NdtCost finish(const std::vector<Standing>& a, const NdtLevel& level, const Matrix3d& b_from_a) {
    for (std::size_t at = 0; at < pulls_.size(); ++at) {
      const Matrix3d covariance = b_from_a * level.cells[a[at].number].mean_covariance * b_from_a.transpose();
      sum_.scatter += pulls_[at] * covariance * pulls_[at].transpose();
    }
    return sum_;
  }
  void count_matched() { ++sum_.matched; }

 private:
  void add_derivatives(const Standing& a, const Matrix3d& inverse, const Vector3d& u, double factor) {
    const Vector3d s = b_->covariance * u;
    const Vector3d e = b_->mean - s;
    const Matrix3d crossing_u = crossing(u);
    const Matrix3d turned = b_->covariance * crossing_u;
    Matrix36d k;
    k.leftCols<3>().setIdentity();
    k.rightCols<3>() = -crossing(e) - turned;
    Vector6d half_gradient;
    half_gradient << u, e.cross(u);
    const Pull kb = k.transpose() * inverse;
    const double scale = config_.weight * factor;
    const Matrix6d information = scale * kb * k;
    Matrix3d turning = u * e.transpose() + e * u.transpose() - 2.0 * crossing_u.transpose() * turned;
    turning.diagonal().array() -= 2.0 * u.dot(e);
    sum_.value -= config_.weight / config_.softness * factor;
    sum_.gradient += scale * half_gradient;
    sum_.information += information;
    sum_.hessian += information - scale * config_.softness * half_gradient * half_gradient.transpose();
    sum_.hessian.topRightCorner<3, 3>() += 0.5 * scale * crossing_u;
    sum_.hessian.bottomLeftCorner<3, 3>() -= 0.5 * scale * crossing_u;
    sum_.hessian.bottomRightCorner<3, 3>() += 0.5 * scale * turning;
    if (pulls_.empty()) return;
    pull_ += scale * kb;
    pulls_[a.number] -= scale * kb;
    // The mean of n n' over a tilt's noise is n n' + tilt^2 (I - n n'): taken off again.
    const Matrix3d lent = a.tilt_variance * (inverse.trace() * Matrix3d::Identity() - inverse);
    sum_.trusted += information - scale * k.transpose() * lent * k;
  }

  NdtCostConfig config_;
  double most_;
  const NdtCell* b_ = nullptr;
  Pull pull_ = Pull::Zero();
  std::vector<Pull> pulls_;  // by a's cells
  NdtCost sum_;
};

}  // namespace

NdtCost ndt_cost(const NdtLevel& a, const NdtLevel& b, const Pose3& a_from_b, const NdtCostConfig& config,
                 bool is_last) {
  const Pose3 b_from_a = a_from_b.inverse();
  const std::vector<Standing> standing = standing_in_b(a, b_from_a);
  const Matrix3d rotation = a_from_b.rotation.toRotationMatrix();
  PairSum sum(config, standing.size(), is_last);
  for (const NdtCell& cell : b.cells) {
    const Surrounding near(a, rotation * cell.mean + a_from_b.translation);
    sum.begin(cell);
    bool is_matched = false;
    for (const std::uint32_t number : near.numbers()) is_matched = sum.add(standing[number]) || is_matched;
    sum.end();
    if (is_matched) sum.count_matched();
  }
  return sum.finish(standing, a, b_from_a.rotation.toRotationMatrix());
}

}  // namespace weft::agents
