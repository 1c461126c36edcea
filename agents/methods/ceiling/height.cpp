#include "agents/methods/ceiling/height.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "agents/perception/lens.hpp"

namespace weft::agents {
namespace {

double variance_of(const ToldHeight& told) {
  return 1.0 / told.information;
}

double density(double off, double variance) {
  return std::exp(-0.5 * off * off / variance) / std::sqrt(variance);
}

/// Returns the height of one that hangs, by a prior of the ceiling's height and how far things hang.
Height hanging(const HeightPrior& prior, const ToldHeight& told) {
  const double before = 1.0 / (prior.hangs_sigma_m * prior.hangs_sigma_m);
  const double information = before + told.information;
  const double mean = (before * prior.ceiling_m + told.information * told.above_floor_m) / information;
  return {std::min(mean, prior.ceiling_m), std::sqrt(1.0 / information)};
}

}  // namespace

ToldHeight together(const ToldHeight& one, const ToldHeight& other) {
  const double both = one.information + other.information;
  if (!(both > 0.0)) return {};
  return {(one.information * one.above_floor_m + other.information * other.above_floor_m) / both, both};
}

ToldHeight scaled(const ToldHeight& told, double factor, double camera_m) {
  return {camera_m + factor * (told.above_floor_m - camera_m), told.information / (factor * factor)};
}

HeightPrior height_prior(const CeilingConfig& config, double ceiling_m, double camera_m) {
  const double lowest = std::min(camera_m + config.least_above_m, 0.5 * (camera_m + ceiling_m));
  return {ceiling_m, config.flat_sigma_m, config.hangs_sigma_m, lowest};
}

double likely_on_ceiling(const HeightPrior& prior, const ToldHeight& told) {
  if (!(told.information > 0.0)) return 0.5;
  const double off = told.above_floor_m - prior.ceiling_m;
  const double variance = variance_of(told);
  const double flat = density(off, variance + prior.flat_sigma_m * prior.flat_sigma_m);
  const double hangs = density(off, variance + prior.hangs_sigma_m * prior.hangs_sigma_m);
  return flat / std::max(flat + hangs, 1e-300);
}

std::optional<Height> height_of(const HeightPrior& prior, const ToldHeight& told) {
  if (told.information > 0.0) {
    constexpr double beyond_sigmas = 4.0;
    const double sigma = std::hypot(std::sqrt(variance_of(told)), prior.flat_sigma_m);
    if (told.above_floor_m > prior.ceiling_m + beyond_sigmas * sigma) return std::nullopt;
    if (told.above_floor_m + sigma < prior.lowest_m) return std::nullopt;
  }
  const double on = likely_on_ceiling(prior, told);
  const Height hangs = hanging(prior, told);
  const double mean = on * prior.ceiling_m + (1.0 - on) * hangs.above_floor_m;
  const double apart = prior.ceiling_m - hangs.above_floor_m;
  const double variance = on * prior.flat_sigma_m * prior.flat_sigma_m + (1.0 - on) * hangs.sigma_m * hangs.sigma_m +
                          on * (1.0 - on) * apart * apart;
  return Height{std::max(mean, prior.lowest_m), std::sqrt(variance)};
}

void set_height(const CameraModel& camera, const Height& height, PlaneFeature& feature) {
  const Eigen::Vector3d& eye = camera.robot_from_camera.translation;
  const double share = (height.above_floor_m - eye.z()) / (feature.above_floor_m - eye.z());
  feature.on_plane = eye.head<2>() + share * (feature.on_plane - eye.head<2>());
  feature.above_floor_m = height.above_floor_m;
  feature.above_floor_sigma_m = height.sigma_m;
}

double HeightTeller::focal(const CameraModel& camera) {
  return focal_px(camera);
}

ToldHeight HeightTeller::told_by(const PlanePair& pair) const {
  constexpr int steps = 3;                 // a height moves a point by its inverse
  constexpr double least_sensitive = 1.0;  // pixels a metre: less tells nothing within the prior
  constexpr double scale_share = 0.01;     // of the distance: how well one keyframe's motion is known
  const double highest = prior_.ceiling_m + 3.0 * prior_.hangs_sigma_m;
  double height = prior_.ceiling_m;
  ToldHeight told;
  for (int i = 0; i < steps; ++i) {
    const Reprojection there = reproject_(pair.in_a, height);
    if (!there.in_front) return {};
    const Eigen::Vector2d px_per_m = focal_px_ * there.by_height;
    if (px_per_m.norm() < least_sensitive) return {};
    const Eigen::Vector2d slope = pair.in_sigmas(px_per_m);
    const double information = slope.squaredNorm();
    if (!(information > 1e-12)) return {};
    const Eigen::Vector2d off = pair.in_sigmas(focal_px_ * (pair.in_b - there.in_b));
    height = std::clamp(height + slope.dot(off) / information, prior_.lowest_m - 0.1, highest);
    if (i + 1 < steps) continue;  // what the motion's own error does is asked of the last one
    const Eigen::Matrix<double, 1, 9> by_motion =
        (focal_px_ / pair.sigma_px / information) * (slope.transpose() * pair.counts * there.jacobian);
    const double motion = by_motion * covariance_ * by_motion.transpose();
    const double scale = scale_share * (height - camera_m_);
    told = {height, 1.0 / (1.0 / information + motion + scale * scale)};
  }
  return told;
}

}  // namespace weft::agents
