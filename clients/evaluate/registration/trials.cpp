#include "clients/evaluate/registration/trials.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace weft::evaluate::registration {
namespace {

constexpr double kSpacingM = 0.5;
constexpr std::size_t kApart = 2;  // places: nearer ones share frames, and with them their noise

std::vector<agents::NdtMap> maps_of(const std::vector<MadePlace>& places, const StereoRig& rig,
                                    const agents::NdtConfig& config) {
  std::vector<agents::NdtMap> maps;
  maps.reserve(places.size());
  for (const MadePlace& place : places) {
    maps.push_back(agents::ndt_map(place.cloud.framed(rig.noise()), config.cells));
  }
  return maps;
}

/// Draws a twist with these standard deviations.
Vector6d drawn(const Vector6d& sigmas, Random& random) {
  Vector6d twist;
  for (int at = 0; at < 6; ++at) twist[at] = random.normal(0.0, sigmas[at]);
  return twist;
}

Trial judged(const Pose3& truth, const Pose3& start, const agents::OrNotRegistered& registered) {
  Trial trial{off(truth, start), off(truth, start), {}, 0.0, 0};
  if (!registered) {
    trial.refused = registered.error().reason;
    return trial;
  }
  const Vector6d error = se3_log(registered->a_from_b.a_from_b.inverse() * truth);
  trial.after = off(truth, registered->a_from_b.a_from_b);
  trial.nees = error.dot(registered->a_from_b.covariance.matrix().ldlt().solve(error));
  trial.from_prior = registered->from_prior;
  return trial;
}

const MadePlace& nearest(const std::vector<MadePlace>& places, const MadePlace& to) {
  return *std::min_element(places.begin(), places.end(), [&](const MadePlace& a, const MadePlace& b) {
    const auto away_m = [&](const MadePlace& place) {
      return (place.world_from_place.translation - to.world_from_place.translation).norm();
    };
    return away_m(a) < away_m(b);
  });
}

}  // namespace

double Off::metres() const {
  return std::hypot(along_m, across_m);
}

Off off(const Pose3& truth, const Pose3& estimated) {
  const Pose2 error = project(truth.inverse() * estimated);
  return {std::abs(error.x), std::abs(error.y), std::abs(error.heading)};
}

Matrix6d EdgePrior::covariance() const {
  Vector6d sigmas;
  sigmas << sigma_m, sigma_m, level_sigma_m, level_sigma_rad, level_sigma_rad, sigma_rad;
  return sigmas.cwiseAbs2().asDiagonal();
}

std::vector<Trial> edge_trials(SceneKind kind, std::uint64_t seed, const EdgePrior& prior,
                               const agents::NdtConfig& config) {
  Random random(seed);
  const StereoRig rig;
  const Scene scene = made_scene(kind, random);
  const std::vector<MadePlace> places = run_through(scene, scene.start, scene.length_m, kSpacingM, rig, random);
  const std::vector<agents::NdtMap> maps = maps_of(places, rig, config);
  const Vector6d sigmas = prior.covariance().diagonal().cwiseSqrt();
  std::vector<Trial> trials;
  for (std::size_t at = kApart; at < places.size(); ++at) {
    const Pose3 truth = places[at - kApart].world_from_place.inverse() * places[at].world_from_place;
    const Metric3 start{truth * se3_exp(drawn(sigmas, random)), prior.covariance()};
    trials.push_back(judged(truth, start.a_from_b, register_with_prior(maps[at - kApart], maps[at], start, config)));
  }
  return trials;
}

std::vector<Trial> stitch_trials(SceneKind kind, std::uint64_t seed, const StitchGuess& guess,
                                 const agents::NdtConfig& config) {
  Random random(seed);
  const StereoRig rig;
  const Scene scene = made_scene(kind, random);
  const Pose2 beside{random.uniform(0.0, 0.4), random.uniform(-0.3, 0.3), random.uniform(-0.1, 0.1)};
  const double length_m = scene.length_m - 0.5;
  const auto first = run_through(scene, scene.start, length_m, kSpacingM, rig, random);
  const auto second = run_through(scene, scene.start * beside, std::min(length_m, 3.0), kSpacingM, rig, random);
  const auto first_maps = maps_of(first, rig, config);
  const auto second_maps = maps_of(second, rig, config);
  Vector6d sigmas;
  sigmas << guess.sigma_m, guess.sigma_m, 0.02, 0.01, 0.01, guess.sigma_rad;
  std::vector<Trial> trials;
  for (std::size_t at = 0; at < second.size(); ++at) {
    const MadePlace& near = nearest(first, second[at]);
    const Pose3 truth = near.world_from_place.inverse() * second[at].world_from_place;
    const Pose3 start = truth * se3_exp(drawn(sigmas, random));
    const auto& map = first_maps[static_cast<std::size_t>(&near - first.data())];
    trials.push_back(judged(truth, start, register_from_guess(map, second_maps[at], start, config)));
  }
  return trials;
}

}  // namespace weft::evaluate::registration
