#include "agents/navigation/belief.hpp"

#include <algorithm>
#include <cmath>

#include "agents/methods/advance.hpp"
#include "core/network/difference.hpp"
#include "core/network/search.hpp"

namespace weft::agents {

namespace {

constexpr double least_variance = 1e-10;  // keeps a covariance that claims certainty invertible

Metric2 fuse_metric(const Metric2& predicted, const Metric2& measured) {
  const Eigen::Matrix3d innovation =
      predicted.covariance + measured.covariance + least_variance * Eigen::Matrix3d::Identity();
  const Eigen::Matrix3d gain = predicted.covariance * innovation.inverse();
  const Eigen::Vector3d apart = se2_log(predicted.a_from_b.inverse() * measured.a_from_b);
  const Eigen::Matrix3d left = (Eigen::Matrix3d::Identity() - gain) * predicted.covariance;
  return {predicted.a_from_b * se2_exp(gain * apart), 0.5 * (left + left.transpose())};
}

Metric3 fuse_metric(const Metric3& predicted, const Metric3& measured) {
  const Matrix6d& before = predicted.covariance;
  const Matrix6d innovation = before + measured.covariance.matrix() + least_variance * Matrix6d::Identity();
  const Matrix6d gain = before * innovation.inverse();
  const Vector6d apart = se3_log(predicted.a_from_b.inverse() * measured.a_from_b);
  const Matrix6d left = (Matrix6d::Identity() - gain) * before;
  return {predicted.a_from_b * se3_exp(gain * apart), 0.5 * (left + left.transpose())};
}

AlongPath fuse_along(const AlongPath& predicted, const AlongPath& measured) {
  const auto gain = [](double variance, double of_measured) {
    return variance / (variance + of_measured + least_variance);
  };
  const double along = gain(predicted.distance_variance_m2, measured.distance_variance_m2);
  const double turn = gain(predicted.heading_variance_rad2, measured.heading_variance_rad2);
  const double shift = wrap_angle(measured.heading_shift_rad - predicted.heading_shift_rad);
  return {predicted.distance_m + along * (measured.distance_m - predicted.distance_m),
          (1.0 - along) * predicted.distance_variance_m2, wrap_angle(predicted.heading_shift_rad + turn * shift),
          (1.0 - turn) * predicted.heading_variance_rad2};
}

}  // namespace

Relation with_noise(const Relation& relation, double sigma_m, double sigma_rad) {
  const double variance_m2 = sigma_m * sigma_m;
  const double variance_rad2 = sigma_rad * sigma_rad;
  Relation noisy = relation;
  if (auto* const flat = std::get_if<Metric2>(&noisy)) {
    flat->covariance.diagonal() += Eigen::Vector3d(variance_m2, variance_m2, variance_rad2);
  } else if (auto* const metric = std::get_if<Metric3>(&noisy)) {
    Matrix6d covariance = metric->covariance;
    covariance.diagonal().head<3>().array() += variance_m2;
    covariance.diagonal().tail<3>().array() += variance_rad2;
    metric->covariance = covariance;
  } else {
    auto& along = std::get<AlongPath>(noisy);
    along.distance_variance_m2 += variance_m2;
    along.heading_variance_rad2 += variance_rad2;
  }
  return noisy;
}

double disagreement(const BeliefConfig& config, const Relation& predicted, const Relation& measured) {
  if (!config.in_plane) return sigmas_apart(predicted, measured, config.gate_floor_m, config.gate_floor_rad);
  const auto flat = [](const Relation& relation) { return Metric2{planar(relation), planar_covariance(relation)}; };
  return sigmas_apart(flat(predicted), flat(measured), config.gate_floor_m, config.gate_floor_rad);
}

Relation fuse(const Relation& predicted, const Relation& measured) {
  if (predicted.index() != measured.index()) return measured;
  if (const auto* const flat = std::get_if<Metric2>(&predicted))
    return fuse_metric(*flat, std::get<Metric2>(measured));
  if (const auto* const metric = std::get_if<Metric3>(&predicted)) {
    return fuse_metric(*metric, std::get<Metric3>(measured));
  }
  return fuse_along(std::get<AlongPath>(predicted), std::get<AlongPath>(measured));
}

std::optional<Relation> between(const BeliefConfig& config, const Window& window, const PlaceId& a, const PlaceId& b,
                                std::uint32_t hops) {
  constexpr std::uint32_t cap = 2000;
  for (const Reached& reached : breadth_first(window, a, hops, cap)) {
    if (reached.id != b) continue;
    const double edges = std::sqrt(static_cast<double>(reached.depth));
    return with_noise(reached.centre_from_place, edges * config.map_sigma_m, edges * config.map_sigma_rad);
  }
  return std::nullopt;
}

void Belief::advance(const Step& told) {
  const Step step = errors_.improved(told);
  if (estimate_) {
    estimate_->place_from_robot = advanced(estimate_->place_from_robot, step, common_);
    estimate_->blind_m += distance_m(step.previous_from_current);
  }
  if (proposed_) {
    proposed_->place_from_robot = advanced(proposed_->place_from_robot, step, common_of_proposed_);
  }
}

CommonErrors Belief::left_of_common(const Relation& predicted, const Fix& fix, const Relation& believed) {
  if (!config_.fuse) return CommonErrors::Zero();
  const auto* const along = std::get_if<AlongPath>(&predicted);
  const auto* const measured = std::get_if<AlongPath>(&fix.place_from_robot);
  if (along == nullptr || measured == nullptr) return corrected(common_, predicted, believed);
  CommonErrors left = common_;
  errors_.learn(*along, *measured, left);
  return left;
}

void Belief::set(const Fix& fix) {
  estimate_ = Estimate{fix.place, fix.place_from_robot, 0.0};
  common_.setZero();
  proposed_.reset();
  agreed_ = 0;
}

void Belief::forget() {
  estimate_.reset();
  proposed_.reset();
  agreed_ = 0;
}

void Belief::withdraw() {
  proposed_.reset();
  agreed_ = 0;
}

OrRefusal<Fix> Belief::correct(const Fix& fix, const Relation& predicted, const Window& window) {
  const double sigmas = disagreement(config_, predicted, fix.place_from_robot);
  if (sigmas > config_.gate_sigmas) {
    // Fixes that contradict the prediction again and again, but never one another, show that the prediction is wrong.
    OrRefusal<Fix> overruled = propose(fix, window, config_.overrule_fixes);
    if (overruled) return overruled;
    return tl::unexpected(Refusal{"disagrees_with_prediction", sigmas, config_.gate_sigmas});
  }
  Fix believed = fix;
  if (config_.fuse) believed.place_from_robot = fuse(predicted, fix.place_from_robot);
  const CommonErrors left = left_of_common(predicted, fix, believed.place_from_robot);
  set(believed);
  common_ = left;
  return believed;
}

OrRefusal<Fix> Belief::propose(const Fix& fix, const Window& window, std::uint32_t needed) {
  constexpr std::uint32_t hops = 25;
  bool agrees = false;
  if (proposed_) {
    const auto here_from_there = between(config_, window, fix.place, proposed_->place, hops);
    agrees = here_from_there && disagreement(config_, compose(*here_from_there, proposed_->place_from_robot),
                                             fix.place_from_robot) <= config_.gate_sigmas;
  }
  agreed_ = agrees ? agreed_ + 1 : 1;
  const std::uint32_t count = agreed_;
  if (count >= needed) {
    set(fix);
    return fix;
  }
  proposed_ = fix;
  common_of_proposed_.setZero();
  return tl::unexpected(Refusal{"unconfirmed", static_cast<double>(count), static_cast<double>(needed)});
}

}  // namespace weft::agents
