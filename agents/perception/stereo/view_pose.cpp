#include "agents/perception/stereo/view_pose.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "agents/perception/robust.hpp"
#include "core/random.hpp"

namespace weft::agents {
namespace {

constexpr double kNearestM = 0.05;  // in front of the camera: nearer is behind it

/// Counts how many points a pose explains: asked for hundreds of poses, so their coordinates lie side by side.
class PoseCounter {
 public:
  PoseCounter(const StereoRig& rig, const std::vector<SeenPoint>& points, double within_px)
      : in_a_(static_cast<Eigen::Index>(points.size()), 3),
        at_b_(static_cast<Eigen::Index>(points.size()), 2),
        most_(static_cast<float>(within_px * within_px / (rig.focal_px * rig.focal_px))) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      in_a_.row(row) = points[i].in_a.cast<float>().transpose();
      at_b_.row(row) = normalised(rig, points[i].at_b).cast<float>().transpose();
    }
  }

  static Eigen::Vector2d normalised(const StereoRig& rig, const Eigen::Vector2d& pixel) {
    return {(pixel.x() - rig.cx) / rig.focal_px, (pixel.y() - rig.cy) / rig.focal_px};
  }

  std::size_t count(const Pose3& b_from_a) {
    const Eigen::Matrix3f r = b_from_a.rotation.toRotationMatrix().cast<float>();
    const Eigen::Vector3f t = b_from_a.translation.cast<float>();
    const auto axis = [&](int i) {
      return r(i, 0) * in_a_.col(0) + r(i, 1) * in_a_.col(1) + r(i, 2) * in_a_.col(2) + t(i);
    };
    z_ = axis(2);
    squares_ = (axis(0) / z_ - at_b_.col(0)).square() + (axis(1) / z_ - at_b_.col(1)).square();
    return static_cast<std::size_t>((squares_ < most_ && z_ > static_cast<float>(kNearestM)).count());
  }

 private:
  Eigen::ArrayX3f in_a_;
  Eigen::ArrayX2f at_b_;
  Eigen::ArrayXf z_, squares_;
  float most_;
};

/// Returns the poses that three points leave open.
std::vector<Pose3> poses_of(const StereoRig& rig, const std::array<const SeenPoint*, 3>& three) {
  std::vector<cv::Point3d> in_a;
  std::vector<cv::Point2d> at_b;
  for (const SeenPoint* point : three) {
    const Eigen::Vector2d at = PoseCounter::normalised(rig, point->at_b);
    in_a.emplace_back(point->in_a.x(), point->in_a.y(), point->in_a.z());
    at_b.emplace_back(at.x(), at.y());
  }
  std::vector<cv::Mat> turns;
  std::vector<cv::Mat> moves;
  cv::solveP3P(in_a, at_b, cv::Matx33d::eye(), cv::noArray(), turns, moves, cv::SOLVEPNP_AP3P);
  std::vector<Pose3> poses;
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const Eigen::Vector3d turn(turns[i].at<double>(0), turns[i].at<double>(1), turns[i].at<double>(2));
    Vector6d twist = Vector6d::Zero();
    twist.tail<3>() = turn;
    Pose3 pose = se3_exp(twist);
    pose.translation = {moves[i].at<double>(0), moves[i].at<double>(1), moves[i].at<double>(2)};
    if (is_finite(pose)) poses.push_back(pose);
  }
  return poses;
}

/// Returns how many draws of three are enough when that share of the points is right: all were wrong with a
/// probability of 1e-4 (Fischler & Bolles 1981).
int draws_for(double share) {
  const double all_three = std::min(share * share * share, 0.99);
  if (all_three < 1e-4) return 1'000'000;
  return static_cast<int>(std::ceil(std::log(1e-4) / std::log(1.0 - all_three)));
}

/// Holds what one point has to say of a pose: column, row and disparity at b.
struct PointResidual {
  bool is_ahead = false;
  double disparity_off_px = 0.0;  ///< what the view makes of the disparity at a, less what was measured there
  int rows = 2;                   ///< 3: its disparity is known
  Eigen::Vector3d off_px = Eigen::Vector3d::Zero();
  Eigen::Matrix<double, 3, 6> by_xi = Eigen::Matrix<double, 3, 6>::Zero();  ///< of what is predicted
  Eigen::Matrix3d information = Eigen::Matrix3d::Zero();

  /// Returns how many sigmas it is off, as if it had two rows.
  double sigmas() const { return std::sqrt(std::max(0.0, 2.0 / rows * off_px.dot(information * off_px))); }
};

/// Returns what the point says. `disparity_off_px`: as the last look at it has left that; the point is taken to be
/// where it says, or noise of disparities would make motions too short (errors in variables).
PointResidual residual_of(const StereoRig& rig, const SeenPoint& point, const PoseBounds& bounds,
                          const Pose3& b_from_a, double disparity_off_px) {
  PointResidual residual;
  const double disparity_at_a = point.disparity_px + disparity_off_px;
  const Eigen::Vector3d in_a = point.in_a * (point.disparity_px / disparity_at_a);
  const Eigen::Vector3d in_b = b_from_a * in_a;
  if (in_b.z() < kNearestM) return residual;
  residual.is_ahead = true;
  const double per_m = rig.focal_px / in_b.z();
  const double disparity = rig.disparity_px(in_b.z());
  const Eigen::Vector2d seen(per_m * in_b.x() + rig.cx, per_m * in_b.y() + rig.cy);
  residual.off_px.head<2>() = point.at_b - seen;
  Eigen::Matrix3d by_point;
  by_point << per_m, 0.0, -per_m * in_b.x() / in_b.z(),  //
      0.0, per_m, -per_m * in_b.y() / in_b.z(),          //
      0.0, 0.0, -disparity / in_b.z();
  // a_from_b * exp(xi) takes a point of b to b's frame moved by -xi: d in_b = -translation + in_b x rotation.
  residual.by_xi.leftCols<3>() = -by_point;
  for (int axis = 0; axis < 3; ++axis)
    residual.by_xi.col(3 + axis) = by_point * in_b.cross(Eigen::Vector3d::Unit(axis));
  const Eigen::Vector3d by_disparity = by_point * (b_from_a.rotation * Eigen::Vector3d(-in_a / disparity_at_a));
  const double track2 = bounds.track_sigma_px * bounds.track_sigma_px;
  const double disparity2 = bounds.disparity_sigma_px * bounds.disparity_sigma_px;
  Eigen::Matrix3d covariance = disparity2 * by_disparity * by_disparity.transpose();
  covariance.diagonal() += Eigen::Vector3d(track2, track2, disparity2);
  if (point.disparity_at_b_px) {
    residual.rows = 3;
    residual.off_px.z() = *point.disparity_at_b_px - disparity;
    residual.information = covariance.inverse();
  } else {
    residual.information.topLeftCorner<2, 2>() = covariance.topLeftCorner<2, 2>().inverse();
  }
  // Against where the measured disparity would be, to the first order.
  residual.off_px += disparity_off_px * by_disparity;
  residual.disparity_off_px = disparity2 * by_disparity.dot(residual.information * residual.off_px);
  return residual;
}

/// Returns what is taken of a point's last look to the next one: nothing of one that says too much.
double carried_over_px(const SeenPoint& point, const PointResidual& before) {
  constexpr double most = 0.5;  // of the disparity
  return std::abs(before.disparity_off_px) < most * point.disparity_px ? before.disparity_off_px : 0.0;
}

/// Returns how much larger residuals are than their sigmas say, at least 1: a median of two-dimensional ones.
double scale_of(const std::vector<PointResidual>& residuals) {
  constexpr double median_of_rayleigh = 1.1774;
  std::vector<double> sigmas;
  for (const PointResidual& residual : residuals)
    if (residual.is_ahead) sigmas.push_back(residual.sigmas());
  return sigmas.empty() ? 1.0 : std::max(1.0, median_of(std::move(sigmas)) / median_of_rayleigh);
}

struct Normal {
  Matrix6d information = Matrix6d::Zero();
  Vector6d pull = Vector6d::Zero();
  std::size_t count = 0;

  void add(const PointResidual& residual, double weight) {
    const Eigen::Matrix<double, 6, 3> weighted = weight * residual.by_xi.transpose() * residual.information;
    information += weighted * residual.by_xi;
    pull += weighted * residual.off_px;
    ++count;
  }
};

}  // namespace

PoseConsensus find_pose(const StereoRig& rig, const std::vector<SeenPoint>& points, const PoseBounds& bounds,
                        const Pose3& expected) {
  PoseCounter counter(rig, points, bounds.within_px);
  PoseConsensus best{expected, counter.count(expected)};
  if (points.size() < 4) return best;
  Random random(0x73746572656FULL);
  const auto share = [&] { return static_cast<double>(best.count) / static_cast<double>(points.size()); };
  int draws = std::min(bounds.hypotheses, draws_for(share()));
  for (int i = 0; i < draws; ++i) {
    const std::size_t first = random.below(points.size());
    const std::size_t second = random.below(points.size());
    const std::size_t third = random.below(points.size());
    if (first == second || first == third || second == third) continue;
    for (const Pose3& pose : poses_of(rig, {&points[first], &points[second], &points[third]})) {
      const std::size_t count = counter.count(pose);
      if (count <= best.count) continue;
      best = {pose, count};
      draws = std::min(draws, draws_for(share()));
    }
  }
  return best;
}

std::optional<PoseFit> fit_pose(const StereoRig& rig, const std::vector<SeenPoint>& points, const PoseBounds& bounds,
                                const Pose3& start) {
  constexpr int most_steps = 10;
  constexpr double settled = 1e-7;
  constexpr double cut = 4.685;  // of Tukey's weight
  PoseFit fit;
  fit.b_from_a = start;
  std::vector<PointResidual> residuals(points.size());
  Normal normal;
  double scale = 1.0;
  for (int step = 0; step < most_steps; ++step) {
    for (std::size_t i = 0; i < points.size(); ++i)
      residuals[i] = residual_of(rig, points[i], bounds, fit.b_from_a, carried_over_px(points[i], residuals[i]));
    scale = scale_of(residuals);
    normal = {};
    for (const PointResidual& residual : residuals) {
      const double weight = residual.is_ahead ? tukey_weight(residual.sigmas(), scale) : 0.0;
      if (weight > 0.0) normal.add(residual, weight);
    }
    if (normal.count < 6) return std::nullopt;
    const Eigen::LDLT<Matrix6d> solver(normal.information);
    if (solver.info() != Eigen::Success || !(solver.vectorD().minCoeff() > 1e-6)) return std::nullopt;
    const Vector6d xi = solver.solve(normal.pull);
    fit.b_from_a = se3_exp(-xi) * fit.b_from_a;
    if (xi.norm() < settled) break;
  }
  fit.covariance = scale * scale * normal.information.ldlt().solve(Matrix6d::Identity());
  double squares = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const PointResidual residual =
        residual_of(rig, points[i], bounds, fit.b_from_a, carried_over_px(points[i], residuals[i]));
    const bool is_inlier = residual.is_ahead && residual.sigmas() < cut * scale &&
                           residual.off_px.head<2>().norm() < 2.0 * bounds.within_px;
    fit.is_inlier.push_back(is_inlier);
    if (!is_inlier) continue;
    ++fit.inliers;
    squares += residual.sigmas() * residual.sigmas();
  }
  if (fit.inliers < 6) return std::nullopt;
  fit.residual_px = bounds.track_sigma_px * std::sqrt(squares / static_cast<double>(fit.inliers));
  return fit;
}

}  // namespace weft::agents
