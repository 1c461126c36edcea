#include "agents/perception/particles/scan_weighing.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

namespace weft::agents {
namespace {

/// Returns weights times likelihoods to a power, adding up to 1.
std::vector<double> weighted_by(const std::vector<double>& before, std::span<const float> logs, double power) {
  const double most = static_cast<double>(*std::max_element(logs.begin(), logs.end()));
  std::vector<double> weights(before.size());
  std::transform(before.begin(), before.end(), logs.begin(), weights.begin(), [&](double weight, float log) {
    return weight * std::exp(power * (static_cast<double>(log) - most));
  });
  const double all = std::accumulate(weights.begin(), weights.end(), 0.0);
  for (double& weight : weights) weight /= all;
  return weights;
}

}  // namespace

double tempered_power(const std::vector<double>& before, std::span<const float> logs, double most, double least) {
  const auto worth = [&](double power) { return effective_count(weighted_by(before, logs, power)); };
  if (worth(most) >= least) return most;
  double good = 0.0;
  double bad = most;
  constexpr int halvings = 8;  // leaves 0.4 % of `most`
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (good + bad);
    (worth(middle) >= least ? good : bad) = middle;
  }
  return good > 0.0 ? good : bad;
}

ScanWeighing::ScanWeighing(const BlurConfig& config, const KldConfig& cells, const LikelihoodField& field,
                           std::vector<BeamEnd> ends, const Eigen::Matrix3d& covariance,
                           const std::optional<ToldPose>& told)
    : config_(config), cells_(cells), field_(field), walk_(covariance), told_(told) {
  widths_.push_back(std::move(ends));
  if (told_) told_information_ = told_->covariance.inverse();
}

std::vector<float> ScanWeighing::logs_of_beams(const ParticleSet& particles) const {
  const std::vector<BeamEnd>& ends = widths_.back();
  std::vector<float> logs(particles.size(), 0.0F);
  if (ends.empty()) return logs;
  field_.weigh(ends, particles, logs);
  const double worth = std::min(1.0, field_.config().worth_beams / static_cast<double>(ends.size()));
  for (float& log : logs) log *= static_cast<float>(worth);
  return logs;
}

std::vector<float> ScanWeighing::logs_of(const ParticleSet& particles) const {
  std::vector<float> logs = logs_of_beams(particles);
  if (!told_) return logs;
  const Pose2 told_from_chart = told_->chart_from_robot.inverse();
  const double blurred = std::pow(0.25, static_cast<double>(widths_.size() - 1));
  for (std::size_t i = 0; i < logs.size(); ++i) {
    const Eigen::Vector3d off = se2_log(told_from_chart * particles.pose(i));
    const double square = blurred * off.dot(told_information_ * off);
    logs[i] += static_cast<float>(std::log(told_->stray + (1.0 - told_->stray) * std::exp(-0.5 * square)));
  }
  return logs;
}

double ScanWeighing::likelihood_of(const ParticleSet& particles) const {
  if (widths_.back().empty()) return 0.0;
  const std::vector<float> logs = told_ ? logs_of_beams(particles) : logs_;
  const auto beams = static_cast<double>(widths_.back().size());
  const double by_beam = std::max(1.0, beams / field_.config().worth_beams) / beams;
  double likelihood = 0.0;
  for (std::size_t i = 0; i < logs.size(); ++i)
    likelihood += particles.weight[i] * std::exp(by_beam * static_cast<double>(logs[i]));
  return likelihood;
}

double ScanWeighing::weigh_by(ParticleSet& particles, std::span<const float> logs) const {
  const double least = config_.least_effective * static_cast<double>(particles.size());
  const double power = tempered_power(particles.weight, logs, 1.0, least);
  particles.weight = weighted_by(particles.weight, logs, power);
  return power;
}

int ScanWeighing::blur(const ParticleSet& particles, int least_blurs) {
  const double least = config_.least_effective * static_cast<double>(particles.size());
  const auto is_enough = [&] { return effective_count(weighted_by(particles.weight, logs_, 1.0)) >= least; };
  int blurs = 0;
  logs_ = logs_of(particles);
  for (; blurs < config_.most && (blurs < least_blurs || !is_enough()); ++blurs) {
    widths_.push_back(widths_.back());
    LikelihoodField::widen(widths_.back());
    logs_ = logs_of(particles);
  }
  return blurs;
}

double ScanWeighing::sharpen(MovedParticles& moved, double power, Random& random) {
  const std::vector<std::size_t> drawn = draw_by_comb(moved.particles.weight, moved.particles.size(), random);
  moved = {drawn_of(moved.particles, drawn), drawn_of(moved.expected, drawn)};
  const auto tempered = [&](const ParticleSet& particles) {
    std::vector<float> logs = logs_of(particles);
    for (float& log : logs) log *= static_cast<float>(power);
    return logs;
  };
  const Eigen::Matrix3d spread = estimate_of(moved.particles, cells_.cell_m, cells_.cell_rad).covariance;
  const std::vector<float> coarse = walk_.walk(moved, tempered, spread, config_.steps, random);
  widths_.pop_back();
  logs_ = logs_of(moved.particles);
  std::vector<float> gains = logs_;
  std::transform(gains.begin(), gains.end(), coarse.begin(), gains.begin(), std::minus<>());
  if (widths_.size() == 1) return weigh_by(moved.particles, gains);
  moved.particles.weight = weighted_by(moved.particles.weight, gains, 1.0);
  return 1.0;
}

ScanWeight ScanWeighing::weigh(MovedParticles& moved, int least_blurs, Random& random) {
  ScanWeight scan;
  scan.blurs = blur(moved.particles, least_blurs);
  scan.power = weigh_by(moved.particles, logs_);
  while (widths_.size() > 1) scan.power = sharpen(moved, scan.power, random);
  scan.likelihood = likelihood_of(moved.particles);
  return scan;
}

}  // namespace weft::agents
