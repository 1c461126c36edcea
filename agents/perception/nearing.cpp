#include "agents/perception/nearing.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace weft::agents {
namespace {

constexpr std::size_t kFewest = 6;
constexpr int kRounds = 8;
constexpr double kSigmaPx = 0.4;  // of a corner's row, at best

struct Row {
  double elevation = 0.0;  // mean of both
  double risen = 0.0;
};

double elevation_of(const UprightFeature& feature, double focal_px) {
  const auto x = static_cast<double>(feature.pixel.x());
  return static_cast<double>(feature.pixel.y()) / std::hypot(focal_px, x);
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// pitch and share that explain the rows, and what is left of each.
struct Fit {
  Eigen::Vector2d pitch_and_share = Eigen::Vector2d::Zero();
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
};

double left_of(const Row& row, const Fit& fit) {
  return row.risen - fit.pitch_and_share[0] - fit.pitch_and_share[1] * row.elevation;
}

/// Tukey's biweight.
double weight_of(double left, double sigma) {
  constexpr double cut = 4.685;
  const double of_cut = left / (cut * sigma);
  if (std::abs(of_cut) >= 1.0) return 0.0;
  const double rest = 1.0 - of_cut * of_cut;
  return rest * rest;
}

}  // namespace

std::optional<Nearing> nearing_of(const std::vector<UprightFeature>& a, const std::vector<UprightFeature>& b,
                                  const std::vector<Match>& same, double focal_px) {
  if (same.size() < kFewest) return std::nullopt;
  std::vector<Row> rows;
  std::vector<double> risen;
  for (const Match& match : same) {
    const double before = elevation_of(a[match.a], focal_px);
    const double after = elevation_of(b[match.b], focal_px);
    rows.push_back({0.5 * (before + after), after - before});
    risen.push_back(after - before);
  }
  const double least_sigma = kSigmaPx / focal_px;
  Fit fit;
  fit.pitch_and_share = {median_of(risen), 0.0};
  double sigma = least_sigma;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<double> left;
    for (const Row& row : rows) left.push_back(std::abs(left_of(row, fit)));
    constexpr double of_mad = 1.4826;
    sigma = std::max(least_sigma, of_mad * median_of(left));
    fit.normal.setZero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (const Row& row : rows) {
      const double weight = weight_of(left_of(row, fit), sigma);
      const Eigen::Vector2d with(1.0, row.elevation);
      fit.normal += weight * with * with.transpose();
      right += weight * row.risen * with;
    }
    const double determinant = fit.normal.determinant();
    constexpr double flat = 1e-4;  // weights times elevations squared
    if (fit.normal(0, 0) < static_cast<double>(kFewest) / 2.0 || determinant < flat * fit.normal(0, 0))
      return std::nullopt;
    fit.pitch_and_share = fit.normal.ldlt().solve(right);
  }
  return Nearing{fit.pitch_and_share[1], sigma * sigma * fit.normal.inverse()(1, 1)};
}

}  // namespace weft::agents
