#include "agents/methods/topometric/space_consensus.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <cmath>
#include <cstdint>

#include "core/random.hpp"

namespace weft::agents {
namespace {

constexpr std::uint64_t kDrawSeed = 0x746F706FULL;
constexpr double kCornerPx = 0.8;  // by which a corner is found elsewhere in another view
constexpr double kShortestBaseM = 0.3;
constexpr double kMostUpM = 0.25;  // by which two pairs of level places may seem to differ in height
constexpr int kFitRounds = 6;

Eigen::Matrix3d covariance_of_feature(const RelateConfig& config, const TopometricContent& content,
                                      const SpaceFeature& feature) {
  const Eigen::Vector3d camera =
      content.floor.level_from_odometry * Eigen::Vector3d(content.rig.robot_from_camera.translation);
  const Eigen::Vector3d ray = feature.in_place.cast<double>() - camera;
  const double away_m = std::max(0.1, ray.norm());
  const double aside_m = std::hypot(config.feature_sigma_m, away_m * kCornerPx / content.rig.focal_px);
  const Eigen::Vector3d along = ray / away_m;
  const double depth_m = static_cast<double>(feature.depth_sigma_m);
  return aside_m * aside_m * Eigen::Matrix3d::Identity() + depth_m * depth_m * along * along.transpose();
}

Eigen::Matrix3d covariance_in_a(const SpacePair& pair, const Eigen::Matrix3d& rotation) {
  return pair.covariance_a + rotation * pair.covariance_b * rotation.transpose();
}

/// Returns the level motion that two pairs leave open; none: they are too near to each other, or too unlike.
std::optional<Pose3> motion_by(const SpacePair& one, const SpacePair& other) {
  const Eigen::Vector3d base_a = other.in_a - one.in_a;
  const Eigen::Vector3d base_b = other.in_b - one.in_b;
  const double long_a = base_a.head<2>().norm();
  const double long_b = base_b.head<2>().norm();
  if (long_a < kShortestBaseM || long_b < kShortestBaseM) return std::nullopt;
  if (std::abs(base_a.z() - base_b.z()) > kMostUpM || long_a > 1.5 * long_b || long_b > 1.5 * long_a)
    return std::nullopt;
  const double turn = std::atan2(base_a.y(), base_a.x()) - std::atan2(base_b.y(), base_b.x());
  Pose3 motion;
  motion.rotation = Eigen::AngleAxisd(turn, Eigen::Vector3d::UnitZ());
  motion.translation = 0.5 * (one.in_a + other.in_a - motion.rotation * (one.in_b + other.in_b));
  if (std::abs(motion.translation.z()) > kMostUpM) return std::nullopt;
  motion.translation.z() = 0.0;
  return motion;
}

std::vector<std::size_t> agreeing(const RelateConfig& config, std::span<const SpacePair> pairs,
                                  const Pose3& a_from_b) {
  std::vector<std::size_t> inliers;
  for (std::size_t i = 0; i < pairs.size(); ++i)
    if (sigmas_off(pairs[i], a_from_b) < config.inlier_sigmas) inliers.push_back(i);
  return inliers;
}

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  return Eigen::Matrix3d{{0.0, -v.z(), v.y()}, {v.z(), 0.0, -v.x()}, {-v.y(), v.x(), 0.0}};
}

/// Is what pairs and prior say at a pose, in xi of a_from_b * se3_exp(xi).
struct NormalEquations {
  Matrix6d of_pairs = Matrix6d::Zero();
  Matrix6d of_prior = Matrix6d::Zero();
  Vector6d gradient = Vector6d::Zero();
};

NormalEquations equations_at(const RelateConfig& config, std::span<const SpacePair> pairs,
                             const std::vector<std::size_t>& inliers, const Metric3& prior, const Pose3& a_from_b) {
  const Eigen::Matrix3d rotation = a_from_b.rotation.toRotationMatrix();
  NormalEquations all;
  for (const std::size_t i : inliers) {
    const Eigen::Matrix3d weight = covariance_in_a(pairs[i], rotation).inverse() / config.inflation;
    Eigen::Matrix<double, 3, 6> slope;
    slope << rotation, -rotation * cross_matrix(pairs[i].in_b);
    const Eigen::Vector3d off = a_from_b * pairs[i].in_b - pairs[i].in_a;
    all.of_pairs += slope.transpose() * weight * slope;
    all.gradient += slope.transpose() * weight * off;
  }
  const Matrix6d information = prior.covariance.matrix().ldlt().solve(Matrix6d::Identity());
  all.of_prior = information;
  all.gradient += information * se3_log(prior.a_from_b.inverse() * a_from_b);
  return all;
}

}  // namespace

std::vector<SpacePair> space_pairs(const RelateConfig& config, const TopometricContent& a, const TopometricContent& b,
                                   std::span<const Match> matches) {
  std::vector<SpacePair> pairs;
  pairs.reserve(matches.size());
  for (const Match& match : matches) {
    const SpaceFeature& in_a = a.features[match.a];
    const SpaceFeature& in_b = b.features[match.b];
    pairs.push_back({in_a.in_place.cast<double>(), in_b.in_place.cast<double>(),
                     covariance_of_feature(config, a, in_a), covariance_of_feature(config, b, in_b)});
  }
  return pairs;
}

double sigmas_off(const SpacePair& pair, const Pose3& a_from_b) {
  const Eigen::Vector3d off = a_from_b * pair.in_b - pair.in_a;
  const Eigen::Matrix3d covariance = covariance_in_a(pair, a_from_b.rotation.toRotationMatrix());
  return std::sqrt(off.dot(covariance.inverse() * off));
}

SpaceConsensus find_space_consensus(const RelateConfig& config, std::span<const SpacePair> pairs) {
  SpaceConsensus best;
  if (pairs.size() < 2) return best;
  Random random(kDrawSeed);
  for (int draw = 0; draw < config.hypotheses; ++draw) {
    const std::size_t one = random.below(pairs.size());
    const std::size_t other = random.below(pairs.size());
    const std::optional<Pose3> motion = motion_by(pairs[one], pairs[other]);
    if (!motion) continue;
    std::vector<std::size_t> inliers = agreeing(config, pairs, *motion);
    if (inliers.size() > best.inliers.size()) best = {*motion, std::move(inliers)};
  }
  return best;
}

std::optional<SpaceFit> fit_space_motion(const RelateConfig& config, std::span<const SpacePair> pairs,
                                         const SpaceConsensus& start, const Metric3& prior) {
  constexpr std::size_t fewest = 3;
  SpaceFit fit{{start.a_from_b, {}}, start.inliers, 0.0};
  for (int round = 0; round < kFitRounds; ++round) {
    if (fit.inliers.size() < fewest) return std::nullopt;
    const NormalEquations all = equations_at(config, pairs, fit.inliers, prior, fit.a_from_b.a_from_b);
    const Vector6d step = (all.of_pairs + all.of_prior).ldlt().solve(-all.gradient);
    fit.a_from_b.a_from_b = fit.a_from_b.a_from_b * se3_exp(step);
    fit.inliers = agreeing(config, pairs, fit.a_from_b.a_from_b);
  }
  if (fit.inliers.size() < fewest) return std::nullopt;
  const NormalEquations all = equations_at(config, pairs, fit.inliers, prior, fit.a_from_b.a_from_b);
  const Matrix6d covariance = (all.of_pairs + all.of_prior).ldlt().solve(Matrix6d::Identity());
  fit.a_from_b.covariance = Matrix6d(0.5 * (covariance + covariance.transpose()));
  for (const std::size_t i : fit.inliers)
    fit.residual_m += (fit.a_from_b.a_from_b * pairs[i].in_b - pairs[i].in_a).squaredNorm();
  fit.residual_m = std::sqrt(fit.residual_m / static_cast<double>(fit.inliers.size()));
  return fit;
}

}  // namespace weft::agents
