#include "agents/perception/rocking_centre.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace weft::agents {
namespace {

constexpr double kWheelScaleSigma = 0.05;
constexpr double kCommandScaleSigma = 0.3;
constexpr double kAheadSigma_rad = 0.02;
constexpr double kAlongSigma_m = 0.001;  // of one step: slip, and what a base makes of a command
constexpr double kAcrossSigma_m = 0.0005;
constexpr double kOutlier = 4.0;    // sigmas
constexpr double kMemory = 3000.0;  // steps: tyres wear, loads change

double along(const Motion& motion) {
  return motion.wheels ? motion.wheels->distance_m : motion.command.linear_m_s * seconds(motion.elapsed);
}

}  // namespace

RockingCentre::RockingCentre(double camera_height_m) : camera_height_m_(camera_height_m) {
  const double half = 0.5 * camera_height_m;
  const Eigen::Vector3d mean(1.0, 0.0, half);
  const Eigen::Vector3d sigma(kWheelScaleSigma, kAheadSigma_rad, half);
  information_ = sigma.cwiseAbs2().cwiseInverse().asDiagonal();
  weighted_ = information_ * mean;
}

Eigen::Vector3d RockingCentre::solution() const {
  return information_.ldlt().solve(weighted_);
}

double RockingCentre::height_m() const {
  return std::clamp(solution().z(), 0.0, camera_height_m_);
}

double RockingCentre::sigma_m() const {
  return std::sqrt(information_.ldlt().solve(Eigen::Vector3d::UnitZ()).z());
}

void RockingCentre::learn(const Pose2& step, const Attitude& change, const Motion& motion) {
  const Eigen::Vector3d now = solution();
  const double loose = motion.wheels ? 1.0 : kCommandScaleSigma / kWheelScaleSigma;
  const auto add = [&](const Eigen::Vector3d& by, double measured, double sigma) {
    if (std::abs(measured - by.dot(now)) > kOutlier * sigma) return;
    information_ += by * by.transpose() / (sigma * sigma);
    weighted_ += by * measured / (sigma * sigma);
  };
  information_ *= 1.0 - 1.0 / kMemory;
  weighted_ *= 1.0 - 1.0 / kMemory;
  // A camera at height h that rocks about height z goes (h - z) pitch ahead and as much roll to the right.
  add({along(motion), 0.0, -change.pitch_rad}, step.x, loose * kAlongSigma_m);
  add({0.0, step.x, change.roll_rad}, step.y - 0.5 * step.x * step.heading, kAcrossSigma_m);
}

Pose2 RockingCentre::corrected(const Pose2& step, const Attitude& change) const {
  const double height = height_m();
  return {step.x + height * change.pitch_rad, step.y - height * change.roll_rad, step.heading};
}

}  // namespace weft::agents
