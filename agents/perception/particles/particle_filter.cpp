#include "agents/perception/particles/particle_filter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "agents/perception/out_of_bounds.hpp"

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

std::vector<Error> check(const ParticleFilterConfig& config) {
  OutOfBounds out("particles");
  const auto own = out.section("");
  own("update_m", config.update_m, Low::closed, 0, 10);
  own("update_rad", config.update_rad, Low::closed, 0, std::numbers::pi);
  own("resample_below", config.resample_below, Low::open, 0, 1);
  own("least_effective", config.least_effective, Low::closed, 0, 0.99);
  own("most_blurs", config.most_blurs, Low::closed, 0, 6);
  own("seeking_blurs", config.seeking_blurs, Low::closed, 0, config.most_blurs);
  const auto kld = out.section("kld");
  kld("epsilon", config.kld.epsilon, Low::open, 0, 1);
  kld("z", config.kld.z, Low::open, 0, 5);
  kld("cell_m", config.kld.cell_m, Low::open, 0, 5);
  kld("cell_rad", config.kld.cell_rad, Low::open, 0, std::numbers::pi);
  kld("most", config.kld.most, Low::closed, 10, 1e6);
  kld("least", config.kld.least, Low::closed, 10, config.kld.most);
  const auto likelihood = out.section("likelihood");
  likelihood("hit_share", config.likelihood.hit_share, Low::open, 0, 0.9999);
  likelihood("beams", config.likelihood.beams, Low::closed, 1, 1000);
  likelihood("worth_beams", config.likelihood.worth_beams, Low::open, 0, 1000);
  likelihood("most_m", config.likelihood.most_m, Low::open, 0, 10);
  likelihood("neutral", config.likelihood.neutral, Low::closed, 0, 1);
  const auto recovery = out.section("recovery");
  recovery("fast", config.recovery.fast, Low::open, 0, 1);
  recovery("slow", config.recovery.slow, Low::open, 0, config.recovery.fast);
  recovery("patience", config.recovery.patience, Low::closed, 1, 10);
  return std::move(out.issues);
}

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

ParticleFilter::ParticleFilter(const ParticleFilterConfig& config, std::uint64_t seed)
    : config_(config), random_(seed) {
  begin_at({}, Eigen::Matrix3d::Zero(), 1);
}

void ParticleFilter::begin_at(const Pose2& chart_from_robot, const Eigen::Matrix3d& covariance, std::size_t count) {
  particles_ = {};
  for (std::size_t i = 0; i < count; ++i) particles_.add(chart_from_robot, 1.0 / static_cast<double>(count));
  move(particles_, {{}, covariance}, random_);
  slow_ = fast_ = 0.0;
  is_new_ = true;
  is_seeking_ = false;
  pending_ = {};
  settle();
}

void ParticleFilter::begin_anywhere(const DrawPose& anywhere, std::size_t count) {
  begin_at({}, Eigen::Matrix3d::Zero(), count);
  inject(particles_, 1.0, anywhere, random_);
  settle();
}

void ParticleFilter::carry_to(const Pose2& new_from_old) {
  take_to(particles_, new_from_old);
  estimate_.chart_from_robot = new_from_old * estimate_.chart_from_robot;
}

bool ParticleFilter::is_due() const {
  const Pose2& moved = pending_.previous_from_current;
  return is_new_ || moved.translation().norm() >= config_.update_m || std::abs(moved.heading) >= config_.update_rad;
}

void ParticleFilter::settle() {
  estimate_ = estimate_of(particles_, config_.kld.cell_m, config_.kld.cell_rad);
}

double ParticleFilter::injected_share(double likelihood) {
  if (slow_ == 0.0) slow_ = fast_ = likelihood;
  slow_ += config_.recovery.slow * (likelihood - slow_);
  fast_ += config_.recovery.fast * (likelihood - fast_);
  return std::max(0.0, 1.0 - config_.recovery.patience * fast_ / slow_);
}

ParticleUpdate ParticleFilter::weigh(const LikelihoodField& field, std::vector<BeamEnd> ends) {
  ParticleUpdate update;
  const auto beams = static_cast<double>(ends.size());
  const double most = std::min(1.0, field.config().worth_beams / beams);
  const double least = config_.least_effective * static_cast<double>(particles_.size());
  std::vector<float> logs(particles_.size(), 0.0F);
  field.weigh(ends, particles_, logs);
  for (std::size_t i = 0; i < logs.size(); ++i)
    update.likelihood += particles_.weight[i] * std::exp(static_cast<double>(logs[i]) / beams);
  std::vector<double> weights = weighted_by(particles_.weight, logs, most);
  const int blurs = is_seeking_ ? config_.seeking_blurs : 0;
  const auto is_enough = [&] { return update.blurs >= blurs && effective_count(weights) >= least; };
  for (; update.blurs < config_.most_blurs && !is_enough(); ++update.blurs) {
    LikelihoodField::widen(ends);
    std::fill(logs.begin(), logs.end(), 0.0F);
    field.weigh(ends, particles_, logs);
    weights = weighted_by(particles_.weight, logs, most);
  }
  update.power = most;
  if (effective_count(weights) < least) {
    update.power = tempered_power(particles_.weight, logs, most, least);
    weights = weighted_by(particles_.weight, logs, update.power);
  }
  particles_.weight = std::move(weights);
  return update;
}

ParticleUpdate ParticleFilter::update(const LikelihoodField& field, const Scan& scan, const DrawPose& anywhere) {
  move(particles_, std::exchange(pending_, {}), random_);
  is_new_ = false;
  std::vector<BeamEnd> ends = field.ends_of(scan);
  if (ends.empty()) {
    settle();
    return {};
  }
  ParticleUpdate update = weigh(field, std::move(ends));
  settle();
  const double injected = injected_share(update.likelihood);
  const bool is_poor =
      effective_count(particles_.weight) < config_.resample_below * static_cast<double>(particles_.size());
  update.injected = anywhere ? injected : 0.0;
  is_seeking_ = update.injected > 0.0;
  if (!is_poor && update.injected <= 0.0) return update;
  particles_ =
      resample(particles_, count_needed(config_.kld, particles_, random_, update.injected, anywhere), random_);
  inject(particles_, update.injected, anywhere, random_);
  return update;
}

ParticleEstimate ParticleFilter::estimate() const {
  const UncertainMotion now = UncertainMotion{estimate_.chart_from_robot, estimate_.covariance} * pending_;
  return {now.previous_from_current, now.covariance, estimate_.share};
}

}  // namespace weft::agents
