#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "agents/methods/method.hpp"
#include "agents/perception/planar_motion.hpp"
#include "agents/perception/plane/guided_match.hpp"

/// Holds what methods that look at a plane have in common when they relate two contents: their configurations name
/// the gate alike, and their contents the attitude.
namespace weft::agents {

template <class Number, class Bound>
tl::unexpected<Refusal> refuse(std::string_view reason, Number measured, Bound bound) {
  return tl::unexpected<Refusal>(Refusal{reason, static_cast<double>(measured), static_cast<double>(bound)});
}

/// Returns three sigmas about a guess, within the configuration's bounds; none without a guess.
template <class Config>
std::optional<MatchGate> gate_about(const Config& c, const std::optional<Relation>& guess) {
  if (!guess) return std::nullopt;
  const Eigen::Matrix3d covariance = planar_covariance(*guess);
  const double spread = 3.0 * std::sqrt(std::max({covariance(0, 0), covariance(1, 1), 0.0}));
  const double turn = 3.0 * std::sqrt(std::max(covariance(2, 2), 0.0));
  return MatchGate{planar(*guess), std::clamp(spread, c.gate_m, std::max(c.gate_m, c.widest_gate_m)),
                   std::clamp(turn, c.gate_rad, 1.6)};
}

/// Returns why a motion lies beyond the gate; nothing: it does not.
inline std::optional<Refusal> beyond_gate(const MatchGate& gate, const Pose2& a_from_b) {
  const Pose2 off = gate.a_from_b.inverse() * a_from_b;
  if (off.translation().norm() > gate.distance_m)
    return Refusal{"disagrees_with_guess", off.translation().norm(), gate.distance_m};
  if (std::abs(off.heading) > gate.heading_rad)
    return Refusal{"disagrees_with_guess", std::abs(off.heading), gate.heading_rad};
  return std::nullopt;
}

/// Returns what both contents say of how their cameras swayed.
template <class Content>
AttitudePrior attitude_prior(const Content& a, const Content& b) {
  AttitudePrior prior;
  prior.mean << a.attitude.vector(), b.attitude.vector();
  Vector6d sigma;
  sigma << a.attitude_sigma, b.attitude_sigma;
  prior.information = sigma.cwiseAbs2().cwiseInverse().asDiagonal();
  return prior;
}

}  // namespace weft::agents
