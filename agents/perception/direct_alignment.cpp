#include "agents/perception/direct_alignment.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "agents/perception/attitude.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/opencv_view.hpp"
#include "agents/perception/plane/geometry.hpp"

namespace weft::agents {
namespace {

constexpr int kSurroundPx = 9;  // of a level: what is larger is light, not the plane

/// Returns a level of a view without its slow changes of brightness.
cv::Mat banded(const cv::Mat& level) {
  cv::Mat grey;
  level.convertTo(grey, CV_32F);
  cv::Mat around;
  cv::boxFilter(grey, around, -1, {kSurroundPx, kSurroundPx});
  return grey - around;
}

/// Holds a pixel of a that is looked for in b.
struct Point {
  Eigen::Vector2d in_a;      // normalised
  Eigen::Vector2f gradient;  // grey levels a level's pixel
  float grey;
};

std::vector<Point> points_of(const CameraModel& camera, const cv::Mat& band, int level, const DirectConfig& config) {
  constexpr int border = kSurroundPx / 2 + 1;
  std::vector<Point> points;
  const double scale = std::ldexp(1.0, level);
  const int columns = std::min(config.columns, (band.cols - 2 * border) / 2);
  const int rows = std::min(config.rows, (band.rows - 2 * border) / 2);
  const auto edge = [](int cell, int cells, int size) { return border + cell * (size - 2 * border) / cells; };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      Point best{{}, {0.0F, 0.0F}, 0.0F};
      float strongest = static_cast<float>(config.least_grey * config.least_grey);
      for (int y = edge(row, rows, band.rows); y < edge(row + 1, rows, band.rows); ++y) {
        const float* const above = band.ptr<float>(y - 1);
        const float* const here = band.ptr<float>(y);
        const float* const below = band.ptr<float>(y + 1);
        for (int x = edge(column, columns, band.cols); x < edge(column + 1, columns, band.cols); ++x) {
          const Eigen::Vector2f twice(here[x + 1] - here[x - 1], below[x] - above[x]);
          if (twice.squaredNorm() <= strongest) continue;
          strongest = twice.squaredNorm();
          // A level's pixel stands for several; its centre is theirs.
          best = {scale * Eigen::Vector2d(x, y), 0.5F * twice, here[x]};
        }
      }
      if (best.gradient.isZero()) continue;
      best.in_a = normalised_from_pixel(camera, best.in_a);
      points.push_back(best);
    }
  }
  return points;
}

/// Returns the grey value between pixels, interpolated; none outside.
std::optional<float> sample(const cv::Mat& band, const Eigen::Vector2d& at) {
  const int x = static_cast<int>(std::floor(at.x()));
  const int y = static_cast<int>(std::floor(at.y()));
  constexpr int border = kSurroundPx / 2 + 1;
  if (x < border || y < border || x + 1 >= band.cols - border || y + 1 >= band.rows - border) return std::nullopt;
  const auto right = static_cast<float>(at.x() - x);
  const auto down = static_cast<float>(at.y() - y);
  const float* const top = band.ptr<float>(y) + x;
  const float* const bottom = band.ptr<float>(y + 1) + x;
  return (1.0F - down) * ((1.0F - right) * top[0] + right * top[1]) +
         down * ((1.0F - right) * bottom[0] + right * bottom[1]);
}

/// Returns the homography b_from_a in normalised coordinates.
Eigen::Matrix3d homography_of(const CameraModel& camera, const PlanarState& state, double above_floor_m) {
  const Pose2 b_from_a = state.a_from_b.inverse();
  const double c = std::cos(b_from_a.heading);
  const double s = std::sin(b_from_a.heading);
  Eigen::Matrix3d planar;
  planar << c, -s, b_from_a.x, s, c, b_from_a.y, 0.0, 0.0, 1.0;
  return camera_from_plane(camera, state.attitude_b, above_floor_m) * planar *
         camera_from_plane(camera, state.attitude_a, above_floor_m).inverse();
}

/// Returns the Jacobian of normalised coordinates of b by those of a around a point.
Eigen::Matrix2d slope_of(const Eigen::Matrix3d& homography, const Eigen::Vector2d& in_a) {
  const Eigen::Vector3d h = homography * in_a.homogeneous();
  const Eigen::Vector2d b = h.head<2>() / h.z();
  return (homography.topLeftCorner<2, 2>() - b * homography.block<1, 2>(2, 0)) / h.z();
}

PlanarState stepped(const PlanarState& state, const Vector9d& step) {
  return {state.a_from_b * se2_exp(step.head<3>()), Attitude::from(state.attitude_a.vector() + step.segment<3>(3)),
          Attitude::from(state.attitude_b.vector() + step.tail<3>())};
}

using Row9f = Eigen::Matrix<float, 1, 9>;

/// Aligns two views by their grey values at one level.
class LevelAlignment {
 public:
  LevelAlignment(const CameraModel& camera, const cv::Mat& a, const cv::Mat& b, int level, const AttitudePrior& prior,
                 const DirectConfig& config)
      : camera_(camera),
        prior_(prior),
        scale_(std::ldexp(1.0, level)),
        above_floor_m_(config.above_floor_m),
        in_b_(banded(b)),
        points_(points_of(camera, banded(a), level, config)) {}

  void solve(DirectFit& out) {
    constexpr int most_linearised = 2;
    constexpr int most_steps = 10;
    constexpr double settled = 2e-5;
    for (int pass = 0; pass < most_linearised; ++pass) {
      linearise(out.fit.state);
      for (int i = 0; i < most_steps; ++i) {
        const Vector9d step = step_from(out);
        if (!step.allFinite()) return;
        out.fit.state = stepped(out.fit.state, step);
        out.fit.converged = step.cwiseAbs().maxCoeff() < settled;
        if (out.fit.converged) break;
      }
    }
    step_from(out);  // for what it says of the solution
    out.fit.covariance = information_.ldlt().solve(Matrix9d::Identity());
  }

 private:
  /// Computes how each point's grey value in b changes with the state, from the gradient in a.
  void linearise(const PlanarState& state) {
    const Eigen::Matrix3d homography = homography_of(camera_, state, above_floor_m_);
    rows_.resize(points_.size());
    const double f = focal_px(camera_) / scale_;
    const Reprojector reproject_here(camera_, camera_, state);
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Reprojection there = reproject_here(points_[i].in_a, above_floor_m_);
      const Eigen::Vector2d gradient_in_b =
          slope_of(homography, points_[i].in_a).inverse().transpose() * points_[i].gradient.cast<double>();
      rows_[i] = (f * gradient_in_b.transpose() * there.jacobian).cast<float>();
    }
  }

  Vector9d step_from(DirectFit& out) {
    const Eigen::Matrix3d homography = homography_of(camera_, out.fit.state, above_floor_m_);
    error_.clear();
    used_.clear();
    double aa = 0.0;
    double bb = 0.0;
    double ab = 0.0;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const Eigen::Vector3d h = homography * points_[i].in_a.homogeneous();
      if (h.z() <= 1e-6) continue;
      const std::optional<float> grey = sample(in_b_, pixel_from_normalised(camera_, h.hnormalized()) / scale_);
      if (!grey) continue;
      used_.push_back(i);
      error_.push_back(points_[i].grey - *grey);
      aa += points_[i].grey * points_[i].grey;
      bb += *grey * *grey;
      ab += points_[i].grey * *grey;
    }
    out.points = used_.size();
    out.correlation = ab / std::sqrt(std::max(aa * bb, 1e-12));
    return solved(out);
  }

  Vector9d solved(DirectFit& out) {
    constexpr float huber = 1.5F;
    constexpr float least_sigma = 0.5F;
    if (used_.empty()) return Vector9d::Constant(std::nan(""));
    sizes_.clear();
    for (const float e : error_) sizes_.push_back(std::abs(e));
    const auto middle = sizes_.begin() + static_cast<std::ptrdiff_t>(sizes_.size() / 2);
    std::nth_element(sizes_.begin(), middle, sizes_.end());
    const float sigma = std::max(1.48F * *middle, least_sigma);
    Eigen::Matrix<float, 9, 9> information = Eigen::Matrix<float, 9, 9>::Zero();
    Eigen::Matrix<float, 9, 1> pull = Eigen::Matrix<float, 9, 1>::Zero();
    for (std::size_t k = 0; k < used_.size(); ++k) {
      const float size = std::abs(error_[k]) / sigma;
      const float weight = (size > huber ? huber / size : 1.0F) / (sigma * sigma);
      const Row9f& row = rows_[used_[k]];
      information.selfadjointView<Eigen::Lower>().rankUpdate(row.transpose(), weight);
      pull.noalias() += weight * error_[k] * row.transpose();
    }
    information = information.selfadjointView<Eigen::Lower>();
    information_ = information.cast<double>();
    information_.bottomRightCorner<6, 6>() += prior_.information;
    Vector9d gradient = pull.cast<double>();
    Vector6d attitude;
    attitude << out.fit.state.attitude_a.vector(), out.fit.state.attitude_b.vector();
    gradient.tail<6>() += prior_.information * (prior_.mean - attitude);
    return information_.ldlt().solve(gradient);
  }

  const CameraModel& camera_;
  const AttitudePrior& prior_;
  double scale_;
  double above_floor_m_;
  cv::Mat in_b_;
  std::vector<Point> points_;
  std::vector<Row9f> rows_;
  std::vector<std::size_t> used_;
  std::vector<float> error_;
  std::vector<float> sizes_;
  Matrix9d information_ = Matrix9d::Identity();
};

}  // namespace

DirectFit align_directly(const CameraModel& camera, const Image& a, const Image& b, const AttitudePrior& prior,
                         const PlanarState& start, const DirectConfig& config) {
  DirectFit out;
  out.fit.state = start;
  std::vector<cv::Mat> levels_a;
  std::vector<cv::Mat> levels_b;
  cv::buildPyramid(as_mat(a), levels_a, config.coarsest);
  cv::buildPyramid(as_mat(b), levels_b, config.coarsest);
  for (int level = config.coarsest; level >= config.finest; --level) {
    const auto at = static_cast<std::size_t>(level);
    out.fit.converged = false;
    LevelAlignment(camera, levels_a[at], levels_b[at], level, prior, config).solve(out);
  }
  return out;
}

std::optional<DirectFit> agreed_directly(const CameraModel& camera, const Image& a, const Image& b,
                                         const AttitudePrior& prior, const PlanarState& start,
                                         const DirectConfig& config) {
  constexpr double least_correlation = 0.5;  // other places give 0.2 at most
  constexpr std::size_t fewest_points = 150;
  DirectFit found = align_directly(camera, a, b, prior, start, config);
  if (!found.fit.converged || found.correlation < least_correlation || found.points < fewest_points)
    return std::nullopt;
  return found;
}

}  // namespace weft::agents
