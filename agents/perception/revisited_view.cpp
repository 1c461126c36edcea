#include "agents/perception/revisited_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "agents/perception/lens.hpp"
#include "agents/perception/opencv_view.hpp"
#include "agents/perception/plane/geometry.hpp"

namespace weft::agents {
namespace {

Eigen::Matrix3d matrix_of(const Pose2& a_from_b) {
  const double c = std::cos(a_from_b.heading);
  const double s = std::sin(a_from_b.heading);
  Eigen::Matrix3d matrix;
  matrix << c, -s, a_from_b.x, s, c, a_from_b.y, 0.0, 0.0, 1.0;
  return matrix;
}

/// Maps each pixel of the other look to where it lies in the image. Computed on a grid: the warp is smooth, and
/// bending every ray by the lens would take longer than all the rest.
cv::Mat2f warp_of(const CameraModel& camera, const OtherLook& look) {
  constexpr int cell = 16;
  const Eigen::Matrix3d camera_from_other = camera_from_floor(camera, Attitude{}) * matrix_of(look.robot_from_other) *
                                            camera_from_floor(camera, look.attitude).inverse();
  const cv::Size grid(camera.width / cell + 2, camera.height / cell + 2);
  cv::Mat2f coarse(grid);
  for (int r = 0; r < grid.height; ++r)
    for (int c = 0; c < grid.width; ++c) {
      // Centres of blocks of cell x cell pixels, as cv::resize takes them.
      const Eigen::Vector2d pixel((c + 0.5) * cell - 0.5, (r + 0.5) * cell - 0.5);
      const Eigen::Vector3d ray = camera_from_other * normalised_from_pixel(camera, pixel).homogeneous();
      const Eigen::Vector2d at = ray.z() > 1e-6 ? pixel_from_normalised(camera, ray.hnormalized()) : pixel;
      coarse(r, c) = {static_cast<float>(at.x()), static_cast<float>(at.y())};
    }
  cv::Mat2f fine;
  cv::resize(coarse, fine, {grid.width * cell, grid.height * cell}, 0, 0, cv::INTER_LINEAR);
  return fine(cv::Rect(0, 0, camera.width, camera.height));
}

/// Draws the grey levels to add, as 128 + grey; later blots cover earlier ones. Draws them larger and averages: most
/// crumbs are smaller than a pixel, and OpenCV draws none smaller than one.
cv::Mat1b drawn(const std::vector<Blot>& blots, const CameraModel& camera, const Attitude& attitude) {
  constexpr int finer = 4;
  constexpr int fraction_bits = 2;
  const Eigen::Matrix3d camera_from_other = camera_from_floor(camera, attitude);
  cv::Mat1b canvas(finer * camera.height, finer * camera.width, std::uint8_t{128});
  std::vector<cv::Point> outline;
  for (const Blot& blot : blots) {
    outline.clear();
    for (const Eigen::Vector2d& corner : blot.outline_on_floor) {
      const Eigen::Vector3d ray = camera_from_other * corner.homogeneous();
      if (ray.z() < 0.05) break;
      // A pixel's centre lies in the middle of its finer ones.
      const Eigen::Vector2d fine =
          finer * pixel_from_normalised(camera, ray.hnormalized()) + Eigen::Vector2d::Constant(0.5 * (finer - 1));
      const Eigen::Vector2d pixel = (1 << fraction_bits) * fine;
      if (!(pixel.cwiseAbs().maxCoeff() < 1e6)) break;
      outline.emplace_back(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y())));
    }
    if (outline.size() < blot.outline_on_floor.size()) continue;
    const double grey = std::clamp(128.0 + blot.grey, 0.0, 255.0);
    cv::fillConvexPoly(canvas, outline, cv::Scalar(grey), cv::LINE_8, fraction_bits);
  }
  cv::Mat1b image;
  cv::resize(canvas, image, {camera.width, camera.height}, 0, 0, cv::INTER_AREA);
  return image;
}

/// Returns grey levels with noise of that sigma, rounded.
Image noisy(cv::Mat grey, double sigma, std::uint64_t seed) {
  cv::RNG random(seed);
  cv::Mat noise(grey.size(), CV_32F);
  random.fill(noise, cv::RNG::NORMAL, 0.0, sigma);
  grey += noise;
  const auto pixels = std::make_shared<Bytes>(static_cast<std::size_t>(grey.total()));
  cv::Mat out(grey.size(), CV_8U, pixels->data());
  grey.convertTo(out, CV_8U);
  return {grey.cols, grey.rows, pixels};
}

}  // namespace

double noise_of(const Image& image) {
  constexpr int block_px = 32;
  constexpr double smoothest = 0.1;  // share of the blocks
  const cv::Mat grey = as_mat(image);
  cv::Mat response;
  const cv::Mat mask = (cv::Mat_<float>(3, 3) << 1, -2, 1, -2, 4, -2, 1, -2, 1);
  cv::filter2D(grey, response, CV_32F, mask);
  cv::Mat1f blocks;
  cv::resize(cv::abs(response), blocks, {std::max(1, grey.cols / block_px), std::max(1, grey.rows / block_px)}, 0, 0,
             cv::INTER_AREA);
  std::vector<float> means(blocks.begin(), blocks.end());
  const auto at = means.begin() + static_cast<std::ptrdiff_t>(smoothest * static_cast<double>(means.size()));
  std::nth_element(means.begin(), at, means.end());
  return std::sqrt(0.5 * std::numbers::pi) / 6.0 * static_cast<double>(*at);
}

Image revisited_view(const Image& image, const CameraModel& camera, const OtherLook& look) {
  cv::Mat floor;
  cv::remap(as_mat(image), floor, warp_of(camera, look), {}, cv::INTER_CUBIC, cv::BORDER_REFLECT_101);
  floor.convertTo(floor, CV_32F, look.light);
  if (look.wear) {
    // Nothing on a floor is sharper in an image than the lens and the motion leave it.
    constexpr double soft_px = 1.0;
    cv::Mat worn;
    drawn(blots_of(*look.wear, look.seed), camera, look.attitude)
        .convertTo(worn, CV_32F, look.light, -128.0 * look.light);
    cv::GaussianBlur(worn, worn, {}, soft_px);
    floor += worn;
  }
  // Interpolation leaves the image's noise nearly whole in the coarser half of what features are made of.
  return noisy(floor, noise_of(image) * std::sqrt(1.0 - look.light * look.light), look.seed);
}

Image darker(const Image& image, double light, std::uint64_t seed) {
  cv::Mat grey;
  as_mat(image).convertTo(grey, CV_32F, light);
  return noisy(grey, noise_of(image) * std::sqrt(1.0 - light * light), seed);
}

}  // namespace weft::agents
