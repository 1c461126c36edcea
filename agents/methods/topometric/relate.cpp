#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "agents/methods/topometric/free_space.hpp"
#include "agents/methods/topometric/level_relation.hpp"
#include "agents/methods/topometric/space_consensus.hpp"
#include "agents/methods/topometric/topometric.hpp"
#include "agents/perception/clouds/ndt.hpp"
#include "agents/perception/clouds/pcl_check.hpp"

namespace weft::agents {
namespace {

tl::unexpected<Refusal> unrelated(std::string_view reason, double measured, double bound) {
  return tl::unexpected<Refusal>(Refusal{reason, measured, bound});
}

std::vector<Descriptor> descriptors_in(const TopometricContent& content) {
  std::vector<Descriptor> descriptors;
  descriptors.reserve(content.features.size());
  for (const SpaceFeature& feature : content.features) descriptors.push_back(feature.descriptor);
  return descriptors;
}

/// Returns one sigma of a relation's position in the direction in which it is known least.
double worst_sigma_m(const Metric3& relation) {
  const Eigen::Matrix2d covariance = planar_covariance(relation).topLeftCorner<2, 2>();
  return std::sqrt(std::max(0.0, Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(covariance).eigenvalues()[1]));
}

/// Holds what stands in each of two places where the other has seen nothing.
struct Standing {
  StandingInFree of_a;
  StandingInFree of_b;
  double less() const { return std::min(of_a.share, of_b.share); }
  double more() const { return std::max(of_a.share, of_b.share); }
};

/// Compares two places step by step. Refers to what it is made of.
class Comparison {
 public:
  Comparison(const TopometricConfig& config, const TopometricContent& a, const TopometricContent& b)
      : config_(config), relate_(config.relate), a_(a), b_(b) {}

  /// Returns the motion that features show with nothing known before.
  OrRefusal<SpaceFit> by_features() const;
  /// Returns the same near a prior; none: too few of them agree.
  std::optional<SpaceFit> by_features(const Metric3& prior) const;
  OrNotRegistered by_clouds(const Metric3& prior) const;
  Standing standing(const Pose3& a_from_b) const;
  /// Returns why what both have seen cannot stand in one room; nothing: it can. Of a wrong relation mostly each has
  /// walls where the other looked through. Where only one has, and features of the place are recognised, something
  /// has come or gone.
  std::optional<Refusal> through_walls(const Standing& standing, bool is_recognised) const;
  /// Returns why another registration, by what stands there for both, does not agree; nothing: it does.
  std::optional<Refusal> second_opinion(const Pose3& a_from_b, const Standing& standing) const;

 private:
  std::vector<Match> matches_near(const Metric3& prior) const;
  /// Returns the points above the floor that do not stand in what is free for the other place. Those on the floor end
  /// where a view ends, and pull two views upon each other: with them the second opinion is 0.2 to 0.6 m off in an
  /// open hall.
  std::vector<Eigen::Vector3f> for_opinion(const TopometricContent& content, const StandingInFree& in_free) const;
  DepthNoise noise_of(const TopometricContent& content) const {
    return {content.rig.focal_px, content.rig.baseline_m, config_.sight.disparity_sigma_px};
  }
  NdtMap map_of(const TopometricContent& content) const {
    return ndt_map(content.cloud.framed(noise_of(content)), config_.ndt.cells);
  }

  const TopometricConfig& config_;
  const RelateConfig& relate_;
  const TopometricContent& a_;
  const TopometricContent& b_;
};

OrRefusal<SpaceFit> Comparison::by_features() const {
  const std::vector<Match> matches =
      match_descriptors(descriptors_in(a_), descriptors_in(b_), {relate_.most_bits, relate_.ratio});
  const auto count = static_cast<double>(matches.size());
  if (count < relate_.fewest_matches) return unrelated("few_matches", count, relate_.fewest_matches);
  const std::vector<SpacePair> pairs = space_pairs(relate_, a_, b_, matches);
  const auto too_few = [&](std::size_t inliers) -> std::optional<Refusal> {
    const auto agree = static_cast<double>(inliers);
    if (agree < relate_.fewest_inliers) return Refusal{"few_inliers", agree, double(relate_.fewest_inliers)};
    if (agree < relate_.fewest_inliers_share * count)
      return Refusal{"few_inliers_share", agree / count, relate_.fewest_inliers_share};
    return std::nullopt;
  };
  const SpaceConsensus consensus = find_space_consensus(relate_, pairs);
  if (const auto wrong = too_few(consensus.inliers.size())) return tl::unexpected(*wrong);
  const double turned_rad = std::abs(project(consensus.a_from_b).heading);
  if (turned_rad > relate_.most_heading_rad)
    return unrelated("opposite_unknown", turned_rad, relate_.most_heading_rad);
  std::optional<SpaceFit> fit =
      fit_space_motion(relate_, pairs, consensus, level_prior_about(relate_, a_, b_, consensus.a_from_b));
  if (const auto wrong = too_few(fit ? fit->inliers.size() : 0)) return tl::unexpected(*wrong);
  return std::move(*fit);
}

std::vector<Match> Comparison::matches_near(const Metric3& prior) const {
  const Eigen::Matrix3d known = planar_covariance(prior);
  const double sigma_rad = std::sqrt(known(2, 2));
  const double near_m = relate_.gate_m + relate_.gate_sigmas * worst_sigma_m(prior);
  std::vector<std::vector<std::uint32_t>> candidates(b_.features.size());
  for (std::size_t j = 0; j < b_.features.size(); ++j) {
    const SpaceFeature& of_b = b_.features[j];
    const Eigen::Vector3d expected = prior.a_from_b * Eigen::Vector3d(of_b.in_place.cast<double>());
    const double turned_m = relate_.gate_sigmas * sigma_rad * static_cast<double>(of_b.in_place.norm());
    for (std::uint32_t i = 0; i < a_.features.size(); ++i) {
      const SpaceFeature& of_a = a_.features[i];
      const auto depth_m = static_cast<double>(std::hypot(of_a.depth_sigma_m, of_b.depth_sigma_m));
      const double within_m = near_m + turned_m + relate_.inlier_sigmas * depth_m;
      if ((of_a.in_place.cast<double>() - expected).squaredNorm() < within_m * within_m) candidates[j].push_back(i);
    }
  }
  return match_descriptors(descriptors_in(a_), descriptors_in(b_), {relate_.most_bits, relate_.ratio_guided},
                           candidates);
}

std::optional<SpaceFit> Comparison::by_features(const Metric3& prior) const {
  const std::vector<SpacePair> pairs = space_pairs(relate_, a_, b_, matches_near(prior));
  const SpaceConsensus consensus = find_space_consensus(relate_, pairs);
  if (consensus.inliers.size() < static_cast<std::size_t>(relate_.fewest_guided)) return std::nullopt;
  std::optional<SpaceFit> fit = fit_space_motion(relate_, pairs, consensus, prior);
  if (!fit || fit->inliers.size() < static_cast<std::size_t>(relate_.fewest_guided)) return std::nullopt;
  return fit;
}

std::vector<Eigen::Vector3f> Comparison::for_opinion(const TopometricContent& content,
                                                     const StandingInFree& in_free) const {
  std::vector<Eigen::Vector3f> points;
  for (std::size_t i = 0; i < content.cloud.points.size(); ++i) {
    const Eigen::Vector3f& point = content.cloud.points[i];
    if (static_cast<double>(point.z()) > 2.0 * config_.rays.floor_m && in_free.is_point[i] == 0)
      points.push_back(point);
  }
  return points;
}

OrNotRegistered Comparison::by_clouds(const Metric3& prior) const {
  return register_with_prior(map_of(a_), map_of(b_), prior, config_.ndt);
}

Standing Comparison::standing(const Pose3& a_from_b) const {
  return {standing_in_free(b_.cloud, a_.cloud, a_from_b.inverse(), config_.rays, noise_of(a_)),
          standing_in_free(a_.cloud, b_.cloud, a_from_b, config_.rays, noise_of(b_))};
}

std::optional<Refusal> Comparison::through_walls(const Standing& standing, bool is_recognised) const {
  const double share = is_recognised ? standing.less() : standing.more();
  if (share <= relate_.most_through) return std::nullopt;
  return Refusal{"through_walls", share, relate_.most_through};
}

std::optional<Refusal> Comparison::second_opinion(const Pose3& a_from_b, const Standing& standing) const {
  const std::vector<Eigen::Vector3f> in_a = for_opinion(a_, standing.of_a);
  const std::vector<Eigen::Vector3f> in_b = for_opinion(b_, standing.of_b);
  const std::size_t fewer = std::min(in_a.size(), in_b.size());
  if (fewer < static_cast<std::size_t>(relate_.fewest_standing))
    return Refusal{"few_standing", static_cast<double>(fewer), static_cast<double>(relate_.fewest_standing)};
  const pcl_check::Opinion opinion = pcl_check::register_p2d_ndt(in_a, in_b, a_from_b, relate_.opinion_cell_m);
  const Pose2 apart = project(a_from_b).inverse() * project(opinion.a_from_b);
  const double away_m = opinion.has_converged ? apart.translation().norm() : relate_.opinion_m * 10.0;
  if (away_m > relate_.opinion_m) return Refusal{"second_opinion", away_m, relate_.opinion_m};
  if (std::abs(apart.heading) > relate_.opinion_rad)
    return Refusal{"second_opinion", std::abs(apart.heading), relate_.opinion_rad};
  return std::nullopt;
}

/// Relates two places of which nothing is known: features first, clouds from what these say, then all that can speak
/// against it. A second registration slides along aisles, and has little to go by at plain walls: it only confirms.
OrRefusal<Related> related_anywhere(const TopometricConfig& config, const Comparison& places) {
  const OrRefusal<SpaceFit> fit = places.by_features();
  if (!fit) return tl::unexpected(fit.error());
  const OrNotRegistered clouds = places.by_clouds(fit->a_from_b);
  if (!clouds) return unrelated(clouds.error().reason, clouds.error().measured, clouds.error().bound);
  if (const double sigma_m = worst_sigma_m(clouds->a_from_b); sigma_m > config.relate.most_sigma_m)
    return unrelated("slides", sigma_m, config.relate.most_sigma_m);
  const Standing standing = places.standing(clouds->a_from_b.a_from_b);
  if (const auto wrong = places.through_walls(standing, true)) return tl::unexpected(*wrong);
  const bool is_confirmed = !places.second_opinion(clouds->a_from_b.a_from_b, standing);
  return Related{clouds->a_from_b,
                 static_cast<std::uint32_t>(fit->inliers.size()),
                 clouds->overlap,
                 fit->residual_m,
                 {},
                 is_confirmed ? standing.more() : 1.0};
}

/// Relates two places near a guess. Where the robots looked opposite ways, clouds alone decide.
OrRefusal<Related> related_near(const TopometricConfig& config, const Comparison& places, const Metric3& guess) {
  const RelateConfig& relate = config.relate;
  const auto is_off = [&](const Metric3& found) -> std::optional<Refusal> {
    const double sigmas = sigmas_from(relate, guess, found.a_from_b);
    if (sigmas <= relate.gate_sigmas) return std::nullopt;
    return Refusal{"disagrees_with_guess", sigmas, relate.gate_sigmas};
  };
  const std::optional<SpaceFit> fit = places.by_features(guess);
  if (fit) {
    if (const auto wrong = is_off(fit->a_from_b)) return tl::unexpected(*wrong);
  }
  if (!fit || fit->inliers.size() < static_cast<std::size_t>(relate.fewest_inliers)) {
    // Clouds stay where a guess has them along an aisle: many features that agree on another place count more.
    if (const OrRefusal<SpaceFit> elsewhere = places.by_features(); elsewhere) {
      if (const auto wrong = is_off(elsewhere->a_from_b)) return tl::unexpected(*wrong);
    }
  }
  const OrNotRegistered clouds = places.by_clouds(fit ? fit->a_from_b : guess);
  if (!clouds && !fit) return unrelated(clouds.error().reason, clouds.error().measured, clouds.error().bound);
  Related related{clouds ? clouds->a_from_b : fit->a_from_b};
  const auto& found = std::get<Metric3>(related.a_from_b);
  if (const auto wrong = is_off(found)) return tl::unexpected(*wrong);
  if (const double sigma_m = worst_sigma_m(found); sigma_m > relate.most_sigma_m)
    return unrelated("slides", sigma_m, relate.most_sigma_m);
  const Standing standing = places.standing(found.a_from_b);
  if (const auto wrong = places.through_walls(standing, fit.has_value())) return tl::unexpected(*wrong);
  related.inliers = static_cast<std::uint32_t>(fit ? fit->inliers.size() : clouds->matched);
  related.overlap = clouds ? clouds->overlap : 0.0;
  related.residual = fit ? fit->residual_m : standing.more();
  related.doubt = standing.more();
  return related;
}

/// Returns how the places lie to each other whose robot frames are related so: these lean as the robot did.
Relation between_level_frames(const TopometricContent& a, const TopometricContent& b, const Metric3& robots) {
  return Metric3{a.floor.level_from_odometry * robots.a_from_b * b.floor.level_from_odometry.inverse(),
                 robots.covariance};
}

}  // namespace

OrRefusal<Related> Topometric::relate(const Content& a, const Content& b,
                                      const std::optional<Relation>& guess) const {
  const Comparison places(config_, a, b);
  if (!guess) return related_anywhere(config_, places);
  return related_near(config_, places, level_prior(config_.relate, a, b, *guess));
}

Relation Topometric::registered(const Content& a, const Content& b, const Relation& a_from_b) const {
  if (std::holds_alternative<AlongPath>(a_from_b)) return a_from_b;
  const auto robots = std::get<Metric3>(compose(Metric3{}, a_from_b));
  const Metric3 odometry = level_prior(config_.relate, a, b, between_level_frames(a, b, robots));
  const auto is_off = [&](const Metric3& found) {
    return sigmas_from(config_.relate, odometry, found.a_from_b) > config_.relate.gate_sigmas;
  };
  const Comparison places(config_, a, b);
  Metric3 best = odometry;
  const std::optional<SpaceFit> fit = places.by_features(odometry);
  const bool is_recognised = fit && !is_off(fit->a_from_b);
  if (is_recognised) best = fit->a_from_b;
  if (const OrNotRegistered clouds = places.by_clouds(best); clouds && !is_off(clouds->a_from_b))
    best = clouds->a_from_b;
  return places.through_walls(places.standing(best.a_from_b), is_recognised) ? odometry : best;
}

}  // namespace weft::agents
