#include "agents/perception/calibration/camera_spread.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "agents/perception/camera_error.hpp"
#include "agents/perception/lens.hpp"

namespace weft::agents {
namespace {

constexpr int kIntrinsics = 8;
using Vector8d = Eigen::Matrix<double, kIntrinsics, 1>;
using Matrix8d = Eigen::Matrix<double, kIntrinsics, kIntrinsics>;
using Matrix86d = Eigen::Matrix<double, kIntrinsics, 6>;

double& intrinsic(CameraModel& camera, int i) {
  const std::array<double*, 4> first = {&camera.fx, &camera.fy, &camera.cx, &camera.cy};
  return i < 4 ? *first[static_cast<std::size_t>(i)] : camera.distortion[static_cast<std::size_t>(i) - 4];
}

Eigen::Vector2d predicted(const CameraModel& camera, const Pose3& camera_from_board,
                          const Eigen::Vector2d& on_board) {
  return pixel_from_normalised(camera,
                               (camera_from_board * Eigen::Vector3d(on_board.x(), on_board.y(), 0.0)).hnormalized());
}

/// Returns the Jacobian of a point's pixel by the intrinsics, by central differences.
Eigen::Matrix<double, 2, kIntrinsics> by_intrinsics(const CameraModel& camera, const Pose3& pose,
                                                    const Eigen::Vector2d& point) {
  Eigen::Matrix<double, 2, kIntrinsics> jacobian;
  for (int i = 0; i < kIntrinsics; ++i) {
    const double step = i < 4 ? 1e-3 : 1e-6;
    CameraModel more = camera;
    CameraModel less = camera;
    intrinsic(more, i) += step;
    intrinsic(less, i) -= step;
    jacobian.col(i) = (predicted(more, pose, point) - predicted(less, pose, point)) / (2.0 * step);
  }
  return jacobian;
}

Eigen::Matrix<double, 2, 6> by_pose(const CameraModel& camera, const Pose3& pose, const Eigen::Vector2d& point) {
  constexpr double step = 1e-6;
  Eigen::Matrix<double, 2, 6> jacobian;
  for (int i = 0; i < 6; ++i) {
    const Vector6d twist = step * Vector6d::Unit(i);
    jacobian.col(i) =
        (predicted(camera, pose * se3_exp(twist), point) - predicted(camera, pose * se3_exp(-twist), point)) /
        (2.0 * step);
  }
  return jacobian;
}

/// Returns the sigma, in pixels, that the coefficients' covariance leaves to the image's corner.
double corner_sigma_px(const CameraModel& camera, const Eigen::Matrix4d& of_coefficients) {
  const Eigen::Vector2d corner = image_corner(camera);
  Eigen::Matrix<double, 2, 4> by_coefficients;
  for (int i = 0; i < 4; ++i) {
    constexpr double step = 1e-6;
    CameraModel more = camera;
    CameraModel less = camera;
    intrinsic(more, 4 + i) += step;
    intrinsic(less, 4 + i) -= step;
    by_coefficients.col(i) =
        (pixel_from_normalised(more, corner) - pixel_from_normalised(less, corner)) / (2.0 * step);
  }
  return std::sqrt((by_coefficients * of_coefficients * by_coefficients.transpose()).trace());
}

}  // namespace

double cover_of(const std::vector<Sighting>& sightings, int width, int height) {
  constexpr int scale = 8;
  cv::Mat seen(height / scale + 1, width / scale + 1, CV_8U, cv::Scalar(0));
  for (const Sighting& sighting : sightings) {
    std::vector<cv::Point> points;
    for (const Eigen::Vector2d& p : sighting.pixels)
      points.emplace_back(static_cast<int>(std::lround(p.x() / scale)), static_cast<int>(std::lround(p.y() / scale)));
    std::vector<cv::Point> hull;
    cv::convexHull(points, hull);
    cv::fillConvexPoly(seen, hull, cv::Scalar(1));
  }
  return static_cast<double>(cv::countNonZero(seen)) / static_cast<double>(seen.total());
}

double widest_tilt(const std::vector<Pose3>& camera_from_board) {
  double widest = 0.0;
  for (const Pose3& a : camera_from_board) {
    for (const Pose3& b : camera_from_board) {
      const double cosine = (a.rotation * Eigen::Vector3d::UnitZ()).dot(b.rotation * Eigen::Vector3d::UnitZ());
      widest = std::max(widest, std::acos(std::clamp(std::abs(cosine), 0.0, 1.0)));
    }
  }
  return widest;
}

CalibrationSigma intrinsics_sigma(const CameraModel& camera, const std::vector<Pose3>& camera_from_board,
                                  const std::vector<Sighting>& sightings) {
  Matrix8d information = Matrix8d::Zero();
  double sum = 0.0;
  std::size_t points = 0;
  for (std::size_t i = 0; i < sightings.size(); ++i) {
    Matrix6d pose_information = Matrix6d::Zero();
    Matrix86d mixed = Matrix86d::Zero();
    for (std::size_t k = 0; k < sightings[i].pixels.size(); ++k) {
      const Eigen::Vector2d& point = sightings[i].on_board[k];
      const auto jc = by_intrinsics(camera, camera_from_board[i], point);
      const auto jp = by_pose(camera, camera_from_board[i], point);
      information += jc.transpose() * jc;
      mixed += jc.transpose() * jp;
      pose_information += jp.transpose() * jp;
      sum += (sightings[i].pixels[k] - predicted(camera, camera_from_board[i], point)).squaredNorm();
      ++points;
    }
    information -= mixed * pose_information.ldlt().solve(mixed.transpose());
  }
  const auto unknowns = static_cast<double>(kIntrinsics + 6 * sightings.size());
  const double freedom = 2.0 * static_cast<double>(points) - unknowns;
  constexpr double infinite = std::numeric_limits<double>::infinity();
  CalibrationSigma sigma;
  sigma.focal_share = sigma.centre_px = sigma.distortion_px = infinite;
  if (freedom <= 0.0) return sigma;
  const Eigen::LDLT<Matrix8d> factors(information);
  if (factors.info() != Eigen::Success || factors.vectorD().minCoeff() <= 0.0) return sigma;
  const Matrix8d covariance = sum / freedom * factors.solve(Matrix8d::Identity());
  Vector8d mean = Vector8d::Zero();
  mean.head<2>().setConstant(0.5);
  sigma.focal_share = std::sqrt(mean.dot(covariance * mean)) / focal_px(camera);
  sigma.centre_px = std::sqrt(std::max(covariance(2, 2), covariance(3, 3)));
  sigma.distortion_px = corner_sigma_px(camera, covariance.bottomRightCorner<4, 4>());
  return sigma;
}

}  // namespace weft::agents
