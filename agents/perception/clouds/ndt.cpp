#include "agents/perception/clouds/ndt.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace weft::agents {
namespace {

constexpr double kStillM = 2e-4;       // steps below it end a level
constexpr double kMostTurnRad = 0.15;  // in one step
constexpr int kMostHalvings = 4;       // of a step that makes the cost larger

tl::unexpected<NotRegistered> refused(std::string_view reason, double measured, double bound) {
  return tl::unexpected<NotRegistered>(NotRegistered{reason, measured, bound});
}

/// Describes what is known before: nothing, when the information is zero.
struct Prior {
  Pose3 a_from_b;
  Matrix6d information = Matrix6d::Zero();
};

/// Returns how far a pose is from the prior's, and how that changes with xi of pose * se3_exp(xi), to second order.
struct FromPrior {
  Vector6d twist;
  Matrix6d slope;

  FromPrior(const Prior& prior, const Pose3& a_from_b) : twist(se3_log(prior.a_from_b.inverse() * a_from_b)) {
    const auto crossing = [](const Eigen::Vector3d& v) {
      return Eigen::Matrix3d{{0.0, -v.z(), v.y()}, {v.z(), 0.0, -v.x()}, {-v.y(), v.x(), 0.0}};
    };
    slope.setIdentity();
    slope.topLeftCorner<3, 3>() += 0.5 * crossing(twist.tail<3>());
    slope.topRightCorner<3, 3>() += 0.5 * crossing(twist.head<3>());
    slope.bottomRightCorner<3, 3>() += 0.5 * crossing(twist.tail<3>());
  }
};

NdtCost with_prior(NdtCost cost, const Prior& prior, const Pose3& a_from_b) {
  const FromPrior from(prior, a_from_b);
  const Matrix6d information = from.slope.transpose() * prior.information * from.slope;
  cost.value += 0.5 * from.twist.dot(prior.information * from.twist);
  cost.gradient += from.slope.transpose() * (prior.information * from.twist);
  cost.hessian += information;
  cost.information += information;
  return cost;
}

/// Returns Newton's step, or Gauss and Newton's where the Hessian is not positive definite; no longer than half a
/// cell.
Vector6d step_down(const NdtCost& cost, double cell_m) {
  Eigen::LLT<Matrix6d> newton(cost.hessian);
  Vector6d step;
  if (newton.info() == Eigen::Success) {
    step = newton.solve(-cost.gradient);
  } else {
    Matrix6d damped = cost.information;
    damped.diagonal().array() += 1e-6 * damped.trace() + 1e-9;
    step = damped.ldlt().solve(-cost.gradient);
  }
  const double longest = std::max(step.head<3>().norm() / (0.5 * cell_m), step.tail<3>().norm() / kMostTurnRad);
  return longest > 1.0 ? Vector6d(step / longest) : step;
}

/// Holds the levels of both clouds that have cells of equal size, the finest first.
struct Shared {
  std::vector<const NdtLevel*> a;
  std::vector<const NdtLevel*> b;
};

Shared shared_levels(const NdtMap& a, const NdtMap& b, std::size_t most) {
  Shared shared;
  for (const NdtLevel& of_a : a.levels) {
    for (const NdtLevel& of_b : b.levels) {
      if (of_a.cell_m != of_b.cell_m || shared.a.size() == most) continue;
      shared.a.push_back(&of_a);
      shared.b.push_back(&of_b);
    }
  }
  return shared;
}

/// Returns the cost of a level's cells, and of those of the levels above that hold points which this one does not.
NdtCost cost_of(const Shared& levels, std::size_t level, const Pose3& a_from_b, const NdtConfig& config,
                bool is_last) {
  NdtCost cost;
  for (std::size_t at = level; at < levels.a.size(); ++at) {
    const CellsOfB which = at == level ? CellsOfB::all : CellsOfB::finest;
    cost += ndt_cost(*levels.a[at], *levels.b[at], a_from_b, config.cost, which, is_last);
  }
  return cost;
}

/// Goes down the cost on one level. Returns the pose where it ends.
Pose3 descend(const Shared& levels, std::size_t level, const Pose3& start, const Prior& prior,
              const NdtConfig& config) {
  const double cell_m = levels.a[level]->cell_m;
  const auto cost_at = [&](const Pose3& pose) {
    return with_prior(cost_of(levels, level, pose, config, false), prior, pose);
  };
  Pose3 best = start;
  NdtCost cost = cost_at(best);
  const double lever_m = 4.0;  // of a radian, for when to end
  const double still_m = kStillM * std::max(1.0, cell_m / 0.2);
  for (int at = 0; at < config.most_steps; ++at) {
    Vector6d step = step_down(cost, cell_m);
    bool is_lower = false;
    for (int halving = 0; halving <= kMostHalvings && !is_lower; ++halving, step *= 0.5) {
      const Pose3 next = best * se3_exp(step);
      const NdtCost there = cost_at(next);
      is_lower = there.value < cost.value;
      if (!is_lower) continue;
      best = next;
      cost = there;
    }
    if (!is_lower || 2.0 * (step.head<3>().norm() + lever_m * step.tail<3>().norm()) < still_m) break;
  }
  return best;
}

/// Holds where the descent ended, and the cost of the finest level's cells there, without the prior.
struct Bottom {
  Pose3 a_from_b;
  NdtCost cost;
  double overlap = 0.0;
  double lever_m = 0.0;  ///< RMS distance of b's cells from its origin
};

tl::expected<Bottom, NotRegistered> go_down(const NdtMap& a, const NdtMap& b, const Prior& prior,
                                            const NdtConfig& config) {
  const Shared levels = shared_levels(a, b, config.cells.levels);
  if (levels.a.empty()) return refused("few_cells", 0.0, static_cast<double>(config.least_matched));
  Bottom bottom{prior.a_from_b, {}, 0.0, 0.0};
  for (std::size_t level = levels.a.size(); level-- > 0;) {
    bottom.a_from_b = descend(levels, level, bottom.a_from_b, prior, config);
  }
  bottom.cost = cost_of(levels, 0, bottom.a_from_b, config, true);
  const std::vector<NdtCell>& finest = levels.b.front()->cells;
  for (const NdtCell& cell : finest) bottom.lever_m += cell.mean.squaredNorm();
  bottom.lever_m = std::sqrt(bottom.lever_m / std::max<double>(1.0, static_cast<double>(finest.size())));
  bottom.overlap =
      static_cast<double>(bottom.cost.matched) / std::max<double>(1.0, static_cast<double>(bottom.cost.cells));
  if (!is_finite(bottom.a_from_b)) return refused("diverged", 0.0, 0.0);
  if (bottom.cost.matched < config.least_matched) {
    return refused("few_cells", static_cast<double>(bottom.cost.matched), static_cast<double>(config.least_matched));
  }
  if (bottom.overlap < config.least_overlap) return refused("little_overlap", bottom.overlap, config.least_overlap);
  return bottom;
}

/// Returns the covariance of the least cost from that of its gradient: H^-1 Cov(g) H^-1 (Censi 2007; Stoyanov et al.
/// 2012, eq. 17), with the prior as one measurement more.
Matrix6d covariance_of(const Matrix6d& cells, const Matrix6d& scatter, const Matrix6d& prior) {
  const Matrix6d inverse = (cells + prior).ldlt().solve(Matrix6d::Identity());
  const Matrix6d covariance = inverse * (scatter + prior) * inverse;
  return 0.5 * (covariance + covariance.transpose());
}

/// Parts the directions in which the cells know more than the prior from those in which they know less. `basis` has
/// them as columns, orthonormal by the prior's information, those in which the cells know least first.
struct Directions {
  Matrix6d basis;
  Vector6d known;  ///< the cells' information in each, in the prior's

  Directions(const Matrix6d& cells, const Matrix6d& prior) {
    const Eigen::GeneralizedSelfAdjointEigenSolver<Matrix6d> solver(cells, prior);
    basis = solver.eigenvectors();
    known = solver.eigenvalues();
  }
  int below_prior() const { return static_cast<int>((known.array() < 1.0).count()); }
};

}  // namespace

OrNotRegistered register_with_prior(const NdtMap& a, const NdtMap& b, const Metric3& prior, const NdtConfig& config) {
  const Prior known{prior.a_from_b, prior.covariance.matrix().ldlt().solve(Matrix6d::Identity())};
  const auto bottom = go_down(a, b, known, config);
  if (!bottom) return tl::unexpected<NotRegistered>(bottom.error());
  const Vector6d twist = se3_log(prior.a_from_b.inverse() * bottom->a_from_b);
  const double distance = twist.dot(known.information * twist);
  if (distance > config.prior_gate) return refused("disagrees_with_prior", distance, config.prior_gate);
  const Directions directions(bottom->cost.trusted, known.information);
  const int kept = directions.below_prior();
  Vector6d along = directions.basis.transpose() * (known.information * twist);  // of each direction
  along.head(kept).setZero();
  const Matrix6d to_directions = directions.basis.transpose() * known.information;
  Matrix6d covariance =
      to_directions *
      covariance_of(bottom->cost.information, config.inflation * bottom->cost.scatter, known.information) *
      to_directions.transpose();
  covariance.topRows(kept).setZero();
  covariance.leftCols(kept).setZero();
  covariance.diagonal().head(kept).setOnes();
  const Pose3 pose = prior.a_from_b * se3_exp(directions.basis * along);
  return Registered{{pose, directions.basis * covariance * directions.basis.transpose()},
                    bottom->cost.matched,
                    bottom->overlap,
                    kept};
}

OrNotRegistered register_from_guess(const NdtMap& a, const NdtMap& b, const Pose3& guess, const NdtConfig& config) {
  const auto bottom = go_down(a, b, {guess, Matrix6d::Zero()}, config);
  if (!bottom) return tl::unexpected<NotRegistered>(bottom.error());
  Matrix6d metres = Matrix6d::Identity();  // turns as metres at their lever
  metres.diagonal().tail<3>().setConstant(1.0 / std::max(bottom->lever_m, 0.1));
  const Matrix6d information = metres * bottom->cost.trusted * metres;
  const double least = Eigen::SelfAdjointEigenSolver<Matrix6d>(information, Eigen::EigenvaluesOnly).eigenvalues()[0];
  const double sigma_m = 1.0 / std::sqrt(std::max(least, 1e-9));
  if (sigma_m > config.slides_m) return refused("slides", sigma_m, config.slides_m);
  return Registered{{bottom->a_from_b, covariance_of(bottom->cost.information,
                                                     config.inflation * bottom->cost.scatter, Matrix6d::Zero())},
                    bottom->cost.matched,
                    bottom->overlap,
                    0};
}

}  // namespace weft::agents
