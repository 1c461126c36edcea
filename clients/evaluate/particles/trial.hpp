#pragma once
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "agents/perception/particles/particle_filter.hpp"
#include "clients/evaluate/particles/carmen_log.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::evaluate::particles {

/// Holds the same for all seeds of a log.
struct Course {
  const std::vector<LaserScan>& scans;
  const agents::LikelihoodField& field;
  agents::DrawPose anywhere;
  double alpha = 0.2;  ///< of AMCL's motion model, as nav2 has it
  std::function<double()> steady_s;
  std::function<bool()> asked_to_stop;
};

/// Holds what came of one seed; both errors of positions in metres.
struct TrialRow {
  std::uint64_t seed = 0;
  std::size_t located = 0;  ///< scans
  double mean_m = 0.0;
  double p95_m = 0.0;
  double worst_m = 0.0;
  double heading_mean_deg = 0.0;
  bool is_lost = false;          ///< kLostScans scans in a row were more than kLostM off
  double odometry_mean_m = 0.0;  ///< of the odometry alone, for comparison
  double particles = 0.0;        ///< in the mean over the updates
  double update_ms = 0.0;        ///< by the clock, in the mean
  double found_after = 0.0;      ///< updates; begun anywhere, else 0; NaN: not found
};
inline constexpr double kLostM = 1.0;
inline constexpr std::size_t kLostScans = 10;
/// A filter that began anywhere has found itself once its estimate is this near, and stays so for kFoundUpdates.
inline constexpr double kFoundM = 0.5;
inline constexpr double kFoundRad = 0.175;
inline constexpr std::size_t kFoundUpdates = 10;
inline constexpr std::size_t kAnywhereParticles = 10'000;

/// Holds a trial with the poses that it was about.
struct Trial {
  TrialRow row;
  std::vector<Pose2> truth;
  std::vector<Pose2> located;
};

/// Locates the scans with odd numbers, begun near the truth. None: stopped.
std::optional<Trial> follow(const Course& course, std::uint64_t seed);

/// Begins anywhere, at a scan of the first half that the seed draws, and locates on until 60 updates after it has
/// found itself, or 200 updates; errors are those after it was found. None: stopped.
std::optional<Trial> find(const Course& course, std::uint64_t seed);

}  // namespace weft::evaluate::particles
