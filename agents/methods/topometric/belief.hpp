#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include "agents/methods/method.hpp"
#include "agents/methods/topometric/chart.hpp"
#include "agents/perception/particles/particle_filter.hpp"

namespace weft::agents {

/// Bounds what particles begin with and what is made of them.
struct TopometricBeliefConfig {
  double least_sigma_m = 0.05;    ///< particles begin spread by so much at least; (0, 1]
  double least_sigma_rad = 0.03;  ///< (0, 1]
  int particles = 1000;           ///< that begin; [10, 100000]
  double sure_seed_m = 0.3;       ///< begun from a wider guess, it takes features to tell a fix; (0, 5]
  double most_sigma_m = 0.4;      ///< spread wider than this they tell no fix: "spread"; (0, 5]
  double most_sigma_rad = 0.2;    ///< (0, 1]
  double least_share = 0.8;       ///< of their weight that lies in one cluster; less: "spread"; [0, 1]
  /// Sets how likely a beam must be at least that ends where the chart knows anything, in the geometric mean: less,
  /// and the robot is somewhere else, "scan_differs"; and what share must end there, "off_the_known": of a way that
  /// was taught the other way round most is unknown. [0, 1]
  double least_likelihood = 0.4;
  double least_known = 0.15;
  int sure_features = 25;  ///< that told: then, what differs is new; [3, 300]
  /// Sets how many scans in a row must fit after one that did not, before one is trusted again: "doubted". Turning in
  /// a place that looks alike, one scan now and then fits. [0, 100]
  int fits_after_doubt = 3;
  /// Is added to what particles say: the map's own error, which all of them share.
  double map_sigma_m = 0.015;    ///< [0, 0.5]
  double map_sigma_rad = 0.005;  ///< [0, 0.5]
  /// Spreads particles by so much more for the square root of a metre driven: calibrations are off, so odometry errs
  /// alike all the way, which its covariance does not say. [0, 0.2]
  double drift_m = 0.015;
  double drift_rad = 0.005;
  double overruled_sigmas = 5.0;  ///< navigation's estimate lies farther off: particles begin anew; (0, 20]
  bool uses_features = true;      ///< else the scan alone weighs particles, as in the paper (III-B)
  double feature_reach_m = 1.5;   ///< features of a place this near are compared; (0, 10]
  double feature_turn_rad = 0.6;  ///< that was seen with a heading this near; (0, pi]
  double looks_alike = 5.0;       ///< so many looks at one place's features count as one: they err alike; [1, 100]
};

/// Holds what is believed about where the robot is: particles in the frame of a chart's centre (Dayoub et al. 2013,
/// III-B).
struct TopometricBelief {
  std::optional<ParticleFilter> filter;            ///< at the last scan that was weighed; none: nothing is believed
  std::optional<Step> since;                       ///< driven after that, all in one
  std::shared_ptr<const TopometricPlaces> places;  ///< of the chart that particles are in
  /// Says that particles began about a mere guess, and no features have confirmed it yet: along an aisle a scan fits
  /// in many places.
  bool is_guess = false;
  std::uint32_t recognised = 0;    ///< features of a place that told where the robot is, at that last scan
  std::uint32_t fits_to_come = 0;  ///< scans that have to fit before one is trusted

  /// Returns where the robot is now in the frame of the chart's centre; the filter is there.
  ParticleEstimate estimate() const;
};

/// Returns the motion of a step in the plane.
UncertainMotion motion_of(const Step& step);

}  // namespace weft::agents
