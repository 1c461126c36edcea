#include "agents/perception/homography.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/calib3d.hpp>

#include "agents/perception/lens.hpp"
#include "agents/perception/opencv_view.hpp"
#include "agents/perception/plane/geometry.hpp"

namespace weft::agents {
namespace {

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

}  // namespace

std::optional<RobustHomography> robust_homography(const std::vector<Eigen::Vector2d>& in_a,
                                                  const std::vector<Eigen::Vector2d>& in_b, double threshold) {
  constexpr std::size_t fewest = 8;
  // OpenCV's estimators stop improving at errors below single precision of pixels: work in units of a nominal lens.
  constexpr double nominal = 500.0;
  if (in_a.size() != in_b.size() || in_a.size() < fewest) return std::nullopt;
  std::vector<cv::Point2f> a;
  std::vector<cv::Point2f> b;
  for (std::size_t i = 0; i < in_a.size(); ++i) {
    a.emplace_back(static_cast<float>(nominal * in_a[i].x()), static_cast<float>(nominal * in_a[i].y()));
    b.emplace_back(static_cast<float>(nominal * in_b[i].x()), static_cast<float>(nominal * in_b[i].y()));
  }
  cv::Mat mask;
  cv::Mat found;
  try {
    found = cv::findHomography(a, b, cv::USAC_PROSAC, nominal * threshold, mask, 1000, 0.995);
  } catch (const cv::Exception&) {
    return std::nullopt;  // degenerate sets make it throw
  }
  if (found.empty()) return std::nullopt;
  const Eigen::Vector3d unit(nominal, nominal, 1.0);
  RobustHomography out;
  out.b_from_a = unit.cwiseInverse().asDiagonal() * as_eigen(cv::Matx33d(found)) * unit.asDiagonal();
  if (!out.b_from_a.allFinite()) return std::nullopt;
  for (std::size_t i = 0; i < in_a.size(); ++i) {
    out.inlier.push_back(mask.at<std::uint8_t>(static_cast<int>(i)) != 0);
    out.inliers += out.inlier.back() ? 1U : 0U;
  }
  return out;
}

std::vector<PlaneMotion> decompose(const Eigen::Matrix3d& b_from_a) {
  std::vector<cv::Mat> rotations;
  std::vector<cv::Mat> translations;
  std::vector<cv::Mat> normals;
  try {
    cv::decomposeHomographyMat(cv::Mat(as_matx(b_from_a)), cv::Mat::eye(3, 3, CV_64F), rotations, translations,
                               normals);
  } catch (const cv::Exception&) {
    return {};
  }
  std::vector<PlaneMotion> candidates;
  for (std::size_t i = 0; i < rotations.size(); ++i) {
    const cv::Vec3d t(translations[i]);
    const cv::Vec3d n(normals[i]);
    PlaneMotion motion{as_eigen(cv::Matx33d(rotations[i])), {t[0], t[1], t[2]}, {n[0], n[1], n[2]}};
    if (motion.normal.z() < 0.0) {  // (t, n) and (-t, -n) are one motion; take the plane that is in front
      motion.normal = -motion.normal;
      motion.translation_in_heights = -motion.translation_in_heights;
    }
    if (motion.normal.allFinite() && motion.rotation.allFinite()) candidates.push_back(motion);
  }
  return candidates;
}

Decomposed choose(const std::vector<PlaneMotion>& candidates, const Eigen::Vector3d& expected_normal,
                  const DecompositionBounds& bounds) {
  Decomposed best;
  best.normal_angle_rad = M_PI;
  double best_passing = bounds.normal_angle_rad;
  for (const PlaneMotion& candidate : candidates) {
    const double before = angle_between(candidate.normal, expected_normal);
    const double after = angle_between(candidate.rotation * candidate.normal, expected_normal);
    const double worst = std::max(before, after);
    best.normal_angle_rad = std::min(best.normal_angle_rad, worst);
    // t is expressed in b, where the normal is R n.
    const double along = std::abs((candidate.rotation * candidate.normal).dot(candidate.translation_in_heights));
    if (worst > best_passing || along > bounds.along_normal_in_heights) continue;
    best_passing = worst;
    best.motion = candidate;
  }
  return best;
}

double huber_distance(double error_px, double eta_px) {
  return 2.0 * eta_px * eta_px * (std::sqrt(1.0 + error_px * error_px / (eta_px * eta_px)) - 1.0);
}

double huber_distance(const Eigen::Matrix3d& b_from_a, const CameraModel& a, double eta_px) {
  const double w = a.width - 1.0;
  const double h = a.height - 1.0;
  double sum = 0.0;
  int count = 0;
  for (const Eigen::Vector2d& pixel : {Eigen::Vector2d(0, 0), Eigen::Vector2d(w, 0), Eigen::Vector2d(0, h),
                                       Eigen::Vector2d(w, h), Eigen::Vector2d(0.5 * w, 0.5 * h)}) {
    const Eigen::Vector2d from = normalised_from_pixel(a, pixel);
    sum += huber_distance(focal_px(a) * (apply(b_from_a, from) - from).norm(), eta_px);
    ++count;
  }
  return sum / count;
}

}  // namespace weft::agents
