#include "agents/perception/particles/particle_filter.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "agents/perception/out_of_bounds.hpp"

namespace weft::agents {

std::vector<Error> check(const ParticleFilterConfig& config) {
  OutOfBounds out("particles");
  const auto own = out.section("");
  own("update_m", config.update_m, Low::closed, 0, 10);
  own("update_rad", config.update_rad, Low::closed, 0, std::numbers::pi);
  own("resample_below", config.resample_below, Low::open, 0, 1);
  const auto blur = out.section("blur");
  blur("least_effective", config.blur.least_effective, Low::closed, 0, 0.99);
  blur("most", config.blur.most, Low::closed, 0, 6);
  blur("seeking", config.blur.seeking, Low::closed, 0, config.blur.most);
  blur("steps", config.blur.steps, Low::closed, 0, 50);
  const auto kld = out.section("kld");
  kld("epsilon", config.kld.epsilon, Low::open, 0, 1);
  kld("z", config.kld.z, Low::open, 0, 5);
  kld("cell_m", config.kld.cell_m, Low::open, 0, 5);
  kld("cell_rad", config.kld.cell_rad, Low::open, 0, std::numbers::pi);
  kld("most", config.kld.most, Low::closed, 10, 1e6);
  kld("least", config.kld.least, Low::closed, 10, config.kld.most);
  const auto likelihood = out.section("likelihood");
  likelihood("hit_share", config.likelihood.hit_share, Low::open, 0, 0.9999);
  likelihood("edge_share", config.likelihood.edge_share, Low::open, 0, 0.9999);
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

ParticleFilter::ParticleFilter(const ParticleFilterConfig& config, std::uint64_t seed)
    : config_(config), random_(seed) {
  begin_at({}, Eigen::Matrix3d::Zero(), 1);
}

void ParticleFilter::begin_at(const Pose2& chart_from_robot, const Eigen::Matrix3d& covariance, std::size_t count) {
  particles_ = {};
  for (std::size_t i = 0; i < count; ++i) particles_.add(chart_from_robot, 1.0 / static_cast<double>(count));
  slow_ = fast_ = 0.0;
  is_new_ = true;
  is_seeking_ = false;
  pending_ = {{}, covariance};
  settle();
}

void ParticleFilter::begin_anywhere(const DrawPose& anywhere, std::size_t count) {
  begin_at({}, Eigen::Matrix3d::Zero(), count);
  seek(1.0, anywhere);
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

MovedParticles ParticleFilter::predict(const UncertainMotion& motion) {
  MovedParticles moved = moved_by(particles_, motion, random_);
  const std::size_t needed = count_needed(config_.kld, moved.particles, random_);
  if (needed <= particles_.size()) return moved;
  return moved_by(resample(particles_, needed, random_), motion, random_);
}

ParticleUpdate ParticleFilter::update(const LikelihoodField& field, const Scan& scan, const DrawPose& anywhere,
                                      const std::optional<ToldPose>& told) {
  const UncertainMotion motion = std::exchange(pending_, {});
  MovedParticles moved = predict(motion);
  is_new_ = false;
  ParticleUpdate update;
  std::vector<BeamEnd> ends = field.ends_of(scan);
  if (!ends.empty() || told) {
    ScanWeighing weighing(config_.blur, config_.kld, field, std::move(ends), motion.covariance, told);
    update.scan = weighing.weigh(moved, is_seeking_ ? config_.blur.seeking : 0, random_);
  }
  particles_ = std::move(moved.particles);
  settle();
  // A robot that is told where it is seeks nothing: what its scan does not know is new.
  if (update.scan.power > 0.0) renew(update, told ? DrawPose() : anywhere);
  return update;
}

void ParticleFilter::renew(ParticleUpdate& update, const DrawPose& anywhere) {
  const bool is_poor =
      effective_count(particles_.weight) < config_.resample_below * static_cast<double>(particles_.size());
  if (anywhere && update.scan.likelihood > 0.0) update.injected = injected_share(update.scan.likelihood);
  is_seeking_ = update.injected > 0.0;
  if (!is_poor && !is_seeking_) return;
  particles_ =
      resample(particles_, count_needed(config_.kld, particles_, random_, update.injected, anywhere), random_);
  if (is_seeking_) seek(update.injected, anywhere);
}

void ParticleFilter::seek(double share, const DrawPose& anywhere) {
  inject(particles_, share, anywhere, random_);
  const double off_m = 0.5 * config_.kld.cell_m;
  const double off_rad = 0.5 * config_.kld.cell_rad;
  pending_.covariance.diagonal() = Eigen::Vector3d(off_m * off_m, off_m * off_m, off_rad * off_rad);
  is_seeking_ = true;
}

ParticleEstimate ParticleFilter::estimate() const {
  const UncertainMotion now = UncertainMotion{estimate_.chart_from_robot, estimate_.covariance} * pending_;
  return {now.previous_from_current, now.covariance, estimate_.share};
}

}  // namespace weft::agents
