#include "agents/perception/calibration/camera_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "agents/perception/calibration/camera_spread.hpp"
#include "agents/perception/lens.hpp"
#include "agents/perception/opencv_view.hpp"

namespace weft::agents {
namespace {

std::string text(double value, int digits) {
  const std::string all = std::to_string(value);
  return all.substr(0, all.find('.') + (digits > 0 ? static_cast<std::size_t>(digits) + 1 : 0));
}
std::string percent(double share) {
  return text(100.0 * share, share < 0.1 ? 1 : 0) + " %";
}
double degrees(double radians) {
  return radians * 180.0 / std::numbers::pi;
}

struct Solved {
  CameraModel camera;
  std::vector<Pose3> camera_from_board;  ///< of each image
};

/// Holds the points as OpenCV calibrates with them: one list for each image.
struct Points {
  std::vector<std::vector<cv::Point3f>> on_board;
  std::vector<std::vector<cv::Point2f>> pixels;
};
Points points_of(const std::vector<const BoardImage*>& images) {
  Points points;
  for (const BoardImage* image : images) {
    auto& on_board = points.on_board.emplace_back();
    auto& pixels = points.pixels.emplace_back();
    for (const Eigen::Vector2d& p : image->sighting.on_board)
      on_board.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()), 0.0F);
    for (const Eigen::Vector2d& p : image->sighting.pixels)
      pixels.emplace_back(static_cast<float>(p.x()), static_cast<float>(p.y()));
  }
  return points;
}

Pose3 pose_from(const cv::Mat& turn, const cv::Mat& shift) {
  cv::Mat rotation;
  cv::Rodrigues(turn, rotation);
  rotation.convertTo(rotation, CV_64F);
  Pose3 pose;
  pose.rotation = Eigen::Quaterniond(as_eigen(cv::Matx33d(rotation))).normalized();
  pose.translation = {shift.at<double>(0), shift.at<double>(1), shift.at<double>(2)};
  return pose;
}

/// Calibrates by OpenCV; this alone calls its two calibrators, which both start from a camera without distortion.
Result<Solved> solve(const std::vector<const BoardImage*>& images, int width, int height, LensModel lens) {
  const Points points = points_of(images);
  const cv::Size size(width, height);
  cv::Mat k;
  cv::Mat d;
  std::vector<cv::Mat> turns;
  std::vector<cv::Mat> shifts;
  try {
    if (lens == LensModel::equidistant) {
      const auto calibrate = [&](int more) {
        turns.clear();
        shifts.clear();
        cv::fisheye::calibrate(points.on_board, points.pixels, size, k, d, turns, shifts,
                               cv::fisheye::CALIB_RECOMPUTE_EXTRINSIC | cv::fisheye::CALIB_FIX_SKEW | more,
                               {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 200, 1e-9});
      };
      calibrate(cv::fisheye::CALIB_FIX_K3 | cv::fisheye::CALIB_FIX_K4);
      // Near the axis nothing tells the higher powers of the angle: they would take absurd values.
      constexpr double wide_rad = 1.05;
      if (std::hypot(width, height) / 2.0 > wide_rad * k.at<double>(0, 0)) calibrate(0);
    } else {
      cv::calibrateCamera(points.on_board, points.pixels, size, k, d, turns, shifts, cv::CALIB_FIX_K3,
                          {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 100, 1e-10});
    }
  } catch (const cv::Exception& problem) {
    return fail(ErrorCode::refused, "no camera explains these images (OpenCV: " + problem.err +
                                        "); are board and --model as stated? Take images with other tilts");
  }
  Solved out;
  out.camera.width = width;
  out.camera.height = height;
  out.camera.fx = k.at<double>(0, 0);
  out.camera.fy = k.at<double>(1, 1);
  out.camera.cx = k.at<double>(0, 2);
  out.camera.cy = k.at<double>(1, 2);
  out.camera.lens = lens;
  for (std::size_t i = 0; i < 4; ++i) out.camera.distortion[i] = d.at<double>(static_cast<int>(i));
  for (std::size_t i = 0; i < turns.size(); ++i) out.camera_from_board.push_back(pose_from(turns[i], shifts[i]));
  return out;
}

std::vector<Eigen::Vector2d> errors_of(const CameraModel& camera, const Pose3& camera_from_board,
                                       const Sighting& sighting) {
  std::vector<Eigen::Vector2d> errors;
  for (std::size_t i = 0; i < sighting.pixels.size(); ++i) {
    const Eigen::Vector2d& p = sighting.on_board[i];
    const Eigen::Vector3d there = camera_from_board * Eigen::Vector3d(p.x(), p.y(), 0.0);
    errors.push_back(sighting.pixels[i] - pixel_from_normalised(camera, there.hnormalized()));
  }
  return errors;
}

double rms(const std::vector<Eigen::Vector2d>& errors) {
  double sum = 0.0;
  for (const Eigen::Vector2d& e : errors) sum += e.squaredNorm();
  return errors.empty() ? 0.0 : std::sqrt(sum / static_cast<double>(errors.size()));
}

/// Finds where an image's board is for a camera that others have determined.
Pose3 pose_for(const CameraModel& camera, const Sighting& sighting) {
  std::vector<cv::Point3d> on_board;
  std::vector<cv::Point2d> rays;
  for (std::size_t i = 0; i < sighting.pixels.size(); ++i) {
    on_board.emplace_back(sighting.on_board[i].x(), sighting.on_board[i].y(), 0.0);
    const Eigen::Vector2d ray = normalised_from_pixel(camera, sighting.pixels[i]);
    rays.emplace_back(ray.x(), ray.y());
  }
  cv::Mat turn;
  cv::Mat shift;
  if (!cv::solvePnP(on_board, rays, cv::Mat::eye(3, 3, CV_64F), cv::noArray(), turn, shift)) return {};
  return pose_from(turn, shift);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Returns which image disagrees most with the others; none when they agree.
std::optional<std::size_t> worst_of(const std::vector<double>& rms_px, const CameraFitConfig& config) {
  const auto worst = static_cast<std::size_t>(std::ranges::max_element(rms_px) - rms_px.begin());
  std::vector<double> others = rms_px;
  others.erase(others.begin() + static_cast<std::ptrdiff_t>(worst));
  const double bound = std::max(config.outlier_px, config.outlier_times * median(std::move(others)));
  return rms_px[worst] > bound ? std::optional(worst) : std::nullopt;
}

/// Solves, leaves out the image that disagrees most, and again, until those that remain agree.
Result<Solved> solve_agreeing(std::vector<const BoardImage*>& used, int width, int height,
                              const CameraFitConfig& config) {
  const std::size_t all = used.size();
  for (;;) {
    Result<Solved> solved = solve(used, width, height, config.lens);
    if (!solved) return solved;
    std::vector<double> rms_px;
    for (std::size_t i = 0; i < used.size(); ++i)
      rms_px.push_back(rms(errors_of(solved->camera, solved->camera_from_board[i], used[i]->sighting)));
    const std::optional<std::size_t> worst = worst_of(rms_px, config);
    if (!worst.has_value()) return solved;
    used.erase(used.begin() + static_cast<std::ptrdiff_t>(*worst));
    const auto left_out = static_cast<double>(all - used.size());
    if (used.size() < config.fewest_images || left_out > config.most_outlier_share * static_cast<double>(all))
      return fail(ErrorCode::refused, "the images contradict one another: " + std::to_string(all - used.size()) +
                                          " of " + std::to_string(all) + " disagree with the others (bound " +
                                          percent(config.most_outlier_share) +
                                          "); is the board flat and its size right, was the focus touched?");
  }
}

Result<void> check_enough(std::size_t count, const CameraFitConfig& config) {
  if (count >= config.fewest_images) return {};
  return fail(ErrorCode::refused, "the board was found in " + std::to_string(count) + " images, at least " +
                                      std::to_string(config.fewest_images) +
                                      " are needed; take more, and check the board's columns and rows");
}

Result<void> check_spread(const CameraFit& fit, const CameraFitConfig& config) {
  if (fit.tilt_rad < config.least_tilt_rad)
    return fail(ErrorCode::refused, "all images show the board from nearly one pose: its attitudes differ by " +
                                        text(degrees(fit.tilt_rad), 1) + " degrees at most, at least " +
                                        text(degrees(config.least_tilt_rad), 0) +
                                        " are needed to tell focal length from distance; tilt it to all sides");
  if (fit.cover < config.least_cover)
    return fail(ErrorCode::refused, "the board was in " + percent(fit.cover) + " of the image's area, at least " +
                                        percent(config.least_cover) +
                                        " are needed to know the lens; hold it nearer and into the corners");
  if (fit.rms_px > config.most_rms_px)
    return fail(ErrorCode::refused, "the reprojection error is " + text(fit.rms_px, 2) + " px, at most " +
                                        text(config.most_rms_px, 0) +
                                        " are allowed; is the board as stated and flat, is --model right?");
  for (const double coefficient : fit.camera.distortion)
    if (std::abs(coefficient) > 1.0)
      return fail(ErrorCode::refused,
                  "a distortion coefficient of " + text(coefficient, 2) +
                      " came out, lenses have -1..1: the images do not determine it; hold the board "
                      "into the corners, or try the other --model");
  if (*fit.camera.sigma.focal_share > config.most_focal_share)
    return fail(ErrorCode::refused, "the images do not determine the focal length: one sigma is " +
                                        percent(*fit.camera.sigma.focal_share) + ", at most " +
                                        percent(config.most_focal_share) +
                                        " is allowed; take more images with the board tilted by 30 degrees");
  return {};
}

}  // namespace

Result<CameraFit> fit_camera(const std::vector<BoardImage>& images, int width, int height,
                             const CameraFitConfig& config) {
  if (const Result<void> enough = check_enough(images.size(), config); !enough) return fail(enough.error());
  std::vector<const BoardImage*> used;
  for (const BoardImage& image : images) used.push_back(&image);
  const Result<Solved> solved = solve_agreeing(used, width, height, config);
  if (!solved) return fail(solved.error());

  CameraFit fit;
  fit.camera = calibration_from(solved->camera);
  fit.camera.body_from_camera.reset();
  double sum = 0.0;
  std::size_t points = 0;
  std::vector<Sighting> sightings;
  for (const BoardImage& image : images) {
    const auto at = std::ranges::find(used, &image);
    const bool is_used = at != used.end();
    const Pose3 pose = is_used ? solved->camera_from_board[static_cast<std::size_t>(at - used.begin())]
                               : pose_for(solved->camera, image.sighting);
    ImageFit one{image.name, is_used, 0.0, image.sighting.pixels, errors_of(solved->camera, pose, image.sighting)};
    one.rms_px = rms(one.error_px);
    if (is_used) {
      sum += one.rms_px * one.rms_px * static_cast<double>(one.pixels.size());
      points += one.pixels.size();
      sightings.push_back(image.sighting);
    }
    fit.images.push_back(std::move(one));
  }
  fit.rms_px = std::sqrt(sum / static_cast<double>(points));
  fit.cover = cover_of(sightings, width, height);
  fit.tilt_rad = widest_tilt(solved->camera_from_board);
  fit.camera.sigma = intrinsics_sigma(solved->camera, solved->camera_from_board, sightings);
  if (const Result<void> spread = check_spread(fit, config); !spread) return fail(spread.error());
  return fit;
}

}  // namespace weft::agents
