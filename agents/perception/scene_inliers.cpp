#include "agents/perception/scene_inliers.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "agents/perception/robust.hpp"

namespace weft::agents {
namespace {

constexpr std::size_t kFewestPairs = 8;
constexpr int kSceneRounds = 10;

struct Raised {
  Eigen::Vector3d by = Eigen::Vector3d::Zero();  // by pitch, roll and share of one
  double elevation = 0.0;                        // tangents, of b less of a
};

Eigen::Vector2d azimuth_and_elevation(const UprightFeature& feature, double focal_px) {
  const Eigen::Vector2d pixel = feature.pixel.cast<double>();
  return {std::atan2(pixel.x(), focal_px), pixel.y() / std::hypot(focal_px, pixel.x())};
}

std::vector<Raised> raised(const std::vector<UprightFeature>& a, const std::vector<UprightFeature>& b,
                           const std::vector<Match>& same, double focal_px) {
  std::vector<Raised> all;
  for (const Match& match : same) {
    const Eigen::Vector2d before = azimuth_and_elevation(a[match.a], focal_px);
    const Eigen::Vector2d after = azimuth_and_elevation(b[match.b], focal_px);
    const Eigen::Vector2d mean = 0.5 * (before + after);
    const double at = 1.0 + mean.y() * mean.y();
    all.push_back({{at * std::cos(mean.x()), at * std::sin(mean.x()), mean.y()}, after.y() - before.y()});
  }
  return all;
}

double left_of(const Raised& one, const Eigen::Vector3d& pitch_roll_share) {
  return one.elevation - one.by.dot(pitch_roll_share);
}

/// Fits by least squares with Tukey's weights, from the median pitch on; a weak prior keeps at 0 what nothing shows.
Eigen::Vector3d fit(const std::vector<Raised>& all, double least_sigma) {
  constexpr double prior_sigma = 0.3;  // radians, and share
  std::vector<double> values;
  for (const Raised& one : all) values.push_back(one.elevation);
  Eigen::Vector3d found(median_of(values), 0.0, 0.0);
  for (int round = 0; round < kSceneRounds; ++round) {
    values.clear();
    for (const Raised& one : all) values.push_back(std::abs(left_of(one, found)));
    const double sigma = std::max(least_sigma, kSigmaOfMad * median_of(values));
    Eigen::Matrix3d normal = Eigen::Matrix3d::Identity() * (sigma * sigma / (prior_sigma * prior_sigma));
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (const Raised& one : all) {
      const double weight = tukey_weight(left_of(one, found), sigma);
      normal += weight * one.by * one.by.transpose();
      right += weight * one.elevation * one.by;
    }
    found = normal.ldlt().solve(right);
  }
  return found;
}

}  // namespace

std::uint32_t scene_inliers(const std::vector<UprightFeature>& a, const std::vector<UprightFeature>& b,
                            const std::vector<Match>& same, double focal_px, double within_px) {
  if (same.size() < kFewestPairs) return 0;
  constexpr double corner_px = 0.4;  // of a corner's row, at best
  const std::vector<Raised> all = raised(a, b, same, focal_px);
  const Eigen::Vector3d found = fit(all, corner_px / focal_px);
  return static_cast<std::uint32_t>(std::count_if(all.begin(), all.end(), [&](const Raised& one) {
    return std::abs(left_of(one, found)) * focal_px <= within_px;
  }));
}

}  // namespace weft::agents
