#include "agents/perception/looming.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "agents/perception/robust.hpp"

namespace weft::agents {
namespace {

constexpr std::size_t kFewestMatches = 6;
constexpr int kLoomingRounds = 8;
constexpr double kCornerSigmaPx = 0.4;  // of a corner's row or column, at best

struct Row {
  double elevation = 0.0;  // mean of both
  double risen = 0.0;
  double azimuth = 0.0;  // mean of both, to the right
  double turned = 0.0;
};

double elevation_of(const UprightFeature& feature, double focal_px) {
  const auto x = static_cast<double>(feature.pixel.x());
  return static_cast<double>(feature.pixel.y()) / std::hypot(focal_px, x);
}

double azimuth_of(const UprightFeature& feature, double focal_px) {
  return std::atan2(static_cast<double>(feature.pixel.x()), focal_px);
}

/// Holds the pitch and share that explain the rows, and the normal matrix of their fit.
struct Fit {
  Eigen::Vector2d pitch_and_share = Eigen::Vector2d::Zero();
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
};

double left_of(const Row& row, const Fit& fit) {
  return row.risen - fit.pitch_and_share[0] - fit.pitch_and_share[1] * row.elevation;
}

std::vector<Row> rows_of(const std::vector<UprightFeature>& a, const std::vector<UprightFeature>& b,
                         const std::vector<Match>& same, double focal_px) {
  std::vector<Row> rows;
  for (const Match& match : same) {
    const double before = elevation_of(a[match.a], focal_px);
    const double after = elevation_of(b[match.b], focal_px);
    const double left = azimuth_of(a[match.a], focal_px);
    const double right = azimuth_of(b[match.b], focal_px);
    rows.push_back({0.5 * (before + after), after - before, 0.5 * (left + right), right - left});
  }
  return rows;
}

/// Sets the turn that azimuths show once looming is taken off, which moves what lies aside further aside.
void tell_turn(const std::vector<Row>& rows, double least_sigma, Looming& looming) {
  std::vector<double> turns;
  for (const Row& row : rows) turns.push_back(row.turned - 0.5 * looming.share * std::sin(2.0 * row.azimuth));
  double turned = median_of(turns);
  double weights = 0.0;
  double sigma = least_sigma;
  for (int round = 0; round < kLoomingRounds; ++round) {
    std::vector<double> left;
    for (const double turn : turns) left.push_back(std::abs(turn - turned));
    sigma = std::max(least_sigma, kSigmaOfMad * median_of(left));
    double sum = weights = 0.0;
    for (const double turn : turns) {
      const double weight = tukey_weight(turn - turned, sigma);
      sum += weight * turn;
      weights += weight;
    }
    turned = sum / weights;  // at least half of them count
  }
  looming.turned_rad = turned;
  looming.turned_variance_rad2 = sigma * sigma / weights;
  looming.spread_rad = sigma;
}

}  // namespace

std::optional<Looming> looming_of(const std::vector<UprightFeature>& a, const std::vector<UprightFeature>& b,
                                  const std::vector<Match>& same, double focal_px) {
  if (same.size() < kFewestMatches) return std::nullopt;
  const std::vector<Row> rows = rows_of(a, b, same, focal_px);
  std::vector<double> risen;
  for (const Row& row : rows) risen.push_back(row.risen);
  const double least_sigma = kCornerSigmaPx / focal_px;
  Fit fit;
  fit.pitch_and_share = {median_of(risen), 0.0};
  double sigma = least_sigma;
  for (int round = 0; round < kLoomingRounds; ++round) {
    std::vector<double> left;
    for (const Row& row : rows) left.push_back(std::abs(left_of(row, fit)));
    sigma = std::max(least_sigma, kSigmaOfMad * median_of(left));
    fit.normal.setZero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (const Row& row : rows) {
      const double weight = tukey_weight(left_of(row, fit), sigma);
      const Eigen::Vector2d with(1.0, row.elevation);
      fit.normal += weight * with * with.transpose();
      right += weight * row.risen * with;
    }
    const double determinant = fit.normal.determinant();
    constexpr double flat = 1e-4;  // weights times elevations squared
    if (fit.normal(0, 0) < static_cast<double>(kFewestMatches) / 2.0 || determinant < flat * fit.normal(0, 0))
      return std::nullopt;
    fit.pitch_and_share = fit.normal.ldlt().solve(right);
  }
  Looming looming{fit.pitch_and_share[1], sigma * sigma * fit.normal.inverse()(1, 1), 0.0, 0.0,
                  fit.pitch_and_share[0]};
  tell_turn(rows, least_sigma, looming);
  return looming;
}

}  // namespace weft::agents
