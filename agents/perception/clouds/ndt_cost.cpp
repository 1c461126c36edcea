#include "agents/perception/clouds/ndt_cost.hpp"

#include <array>
#include <cmath>

// Everything is in frame b, where the pose's own xi is zero and a cell of a is a plane through c = R'(mean_a - t)
// with normal m = R' n_a and variance A across it. A cell of b at p with covariance S is moved to exp(xi) p. With r =
// m'(p - c), v = m' S m + A, u = r / v, h = S m and s = u h, the squared distance is d = r^2 / v, its gradient 2 u
// [m; (p - s) x m], and its second derivatives
//   2 k k' / v + u [0, [m]x; [m]x', m e' + e m' - 2 (m'e) I - 2 u [m]x' S [m]x],  e = p - s,  k = [m; (e - s) x m].
// This is eq. 7 of Stoyanov et al. 2012 for a covariance of a without an end along its surface, whose inverse sum is
// m m' / v; derived anew from the second order of exp(xi): d counts S as it turns with b.
namespace weft::agents {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kLeastFactor = 0.01;  // pairs further apart count for nothing

Matrix3d crossing(const Vector3d& v) {
  Matrix3d matrix;
  matrix << 0.0, -v.z(), v.y(), v.z(), 0.0, -v.x(), -v.y(), v.x(), 0.0;
  return matrix;
}

/// Describes a cell of a as b sees it.
struct Standing {
  Vector3d mean;
  Vector3d normal;
  double across = 0.0;
  std::uint32_t number = 0;
};

std::vector<Standing> standing_in_b(const NdtLevel& a, const Pose3& b_from_a) {
  const Matrix3d rotation = b_from_a.rotation.toRotationMatrix();
  std::vector<Standing> all;
  all.reserve(a.cells.size());
  for (std::uint32_t number = 0; number < a.cells.size(); ++number) {
    const NdtCell& cell = a.cells[number];
    all.push_back({rotation * cell.mean + b_from_a.translation, rotation * cell.normal, cell.across, number});
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
  std::array<std::uint32_t, 8> numbers_{};  // the first count_ of them
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
    is_matched_ = false;
    if (!pulls_.empty()) pull_.setZero();
  }
  /// Adds a pair, unless it is so far apart that it counts for nothing.
  void add(const Standing& a) {
    const Vector3d h = b_->covariance * a.normal;
    const double variance = a.normal.dot(h) + a.across;
    const double apart = a.normal.dot(b_->mean - a.mean);
    if (apart * apart > most_ * variance) return;
    is_matched_ = true;
    add_derivatives(a, h, apart / variance, 1.0 / variance,
                    std::exp(-0.5 * config_.softness * apart * apart / variance));
  }
  /// Ends the pairs of that cell.
  void end() {
    ++sum_.cells;
    if (is_matched_) ++sum_.matched;
    if (!pulls_.empty() && is_matched_) sum_.scatter += pull_ * b_->mean_covariance * pull_.transpose();
  }
  /// Returns the sum; the means of a's cells, which pairs share, are added last.
  NdtCost finish(const std::vector<Standing>& a, const NdtLevel& level, const Matrix3d& b_from_a) {
    for (std::size_t at = 0; at < pulls_.size(); ++at) {
      const Matrix3d covariance = b_from_a * level.cells[a[at].number].mean_covariance * b_from_a.transpose();
      sum_.scatter += pulls_[at] * covariance * pulls_[at].transpose();
    }
    sum_.hessian.topRightCorner<3, 3>() += crossing(0.5 * slid_);
    sum_.hessian.bottomLeftCorner<3, 3>() -= crossing(0.5 * slid_);
    sum_.hessian.bottomRightCorner<3, 3>() += turned_ + turned_.transpose();
    sum_.hessian += sum_.information;
    return sum_;
  }

 private:
  void add_derivatives(const Standing& a, const Vector3d& h, double u, double per_variance, double factor) {
    const Vector3d& normal = a.normal;
    const Vector3d s = u * h;
    const Vector3d e = b_->mean - s;
    const double scale = config_.weight * factor;
    Vector6d k;
    k << normal, (e - s).cross(normal);
    Vector6d half_gradient;  // of the squared distance
    half_gradient << u * normal, u * e.cross(normal);
    sum_.value -= config_.weight / config_.softness * factor;
    sum_.gradient += scale * half_gradient;
    sum_.information += (scale * per_variance * k) * k.transpose();
    sum_.hessian -= (scale * config_.softness * half_gradient) * half_gradient.transpose();
    slid_ += scale * u * normal;
    turned_ += (0.5 * scale * u * normal) * e.transpose();
    turned_.diagonal().array() -= 0.5 * scale * u * normal.dot(e);
    const Matrix3d turning = crossing(normal);
    turned_ -= (0.5 * scale * u * u) * turning.transpose() * b_->covariance * turning;
    if (!pulls_.empty()) add_last(a, k, e - s, scale * per_variance);
  }
  void add_last(const Standing& a, const Vector6d& k, const Vector3d& arm, double scale) {
    const Pull by_mean = scale * k * a.normal.transpose();
    pull_ += by_mean;
    pulls_[a.number] -= by_mean;
    Vector6d as_b_says;
    as_b_says << b_->normal, arm.cross(b_->normal);
    const Matrix6d both = (0.5 * scale * a.normal.dot(b_->normal) * k) * as_b_says.transpose();
    sum_.trusted += both + both.transpose();
  }

  NdtCostConfig config_;
  double most_;
  const NdtCell* b_ = nullptr;
  bool is_matched_ = false;
  Pull pull_ = Pull::Zero();
  std::vector<Pull> pulls_;  // by a's cells
  Vector3d slid_ = Vector3d::Zero();
  Matrix3d turned_ = Matrix3d::Zero();  // half of the second derivatives by turns that are not in k k'
  NdtCost sum_;
};

}  // namespace

NdtCost& NdtCost::operator+=(const NdtCost& other) {
  value += other.value;
  gradient += other.gradient;
  hessian += other.hessian;
  information += other.information;
  trusted += other.trusted;
  scatter += other.scatter;
  cells += other.cells;
  matched += other.matched;
  return *this;
}

NdtCost ndt_cost(const NdtLevel& a, const NdtLevel& b, const Pose3& a_from_b, const NdtCostConfig& config,
                 CellsOfB which, bool is_last) {
  const Pose3 b_from_a = a_from_b.inverse();
  const std::vector<Standing> standing = standing_in_b(a, b_from_a);
  const Matrix3d rotation = a_from_b.rotation.toRotationMatrix();
  PairSum sum(config, standing.size(), is_last);
  for (const NdtCell& cell : b.cells) {
    if (which == CellsOfB::finest && !cell.is_finest) continue;
    sum.begin(cell);
    const Surrounding near(a, rotation * cell.mean + a_from_b.translation);
    for (const std::uint32_t number : near.numbers()) sum.add(standing[number]);
    sum.end();
  }
  return sum.finish(standing, a, b_from_a.rotation.toRotationMatrix());
}

}  // namespace weft::agents
