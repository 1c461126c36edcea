#pragma once
// Boards as a camera sees them, for tests of calibration: rendered from a print of the board.
#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <opencv2/aruco.hpp>
#include <variant>
#include <vector>

#include "agents/perception/calibration/board.hpp"
#include "agents/perception/camera_model.hpp"
#include "agents/perception/lens.hpp"
#include "core/random.hpp"

namespace weft::agents::test {

/// Holds a print of a board with a white margin; `pixels_per_m` of the paper, the board's first point at `origin_px`.
struct Print {
  cv::Mat grey;
  double pixels_per_m = 0.0;
  Eigen::Vector2d origin_px = Eigen::Vector2d::Zero();
  Eigen::Vector2d middle_m = Eigen::Vector2d::Zero();
};

inline Print print_of(const ChessBoard& board) {
  constexpr int cell = 40;
  Print print;
  print.grey = cv::Mat((board.rows + 3) * cell, (board.columns + 3) * cell, CV_8U, cv::Scalar(235));
  for (int row = 0; row <= board.rows; ++row)
    for (int column = 0; column <= board.columns; ++column)
      if ((row + column) % 2 == 0) print.grey(cv::Rect((column + 1) * cell, (row + 1) * cell, cell, cell)) = 20;
  print.pixels_per_m = cell / board.square_m;
  print.origin_px = {2.0 * cell, 2.0 * cell};
  print.middle_m = 0.5 * board.square_m * Eigen::Vector2d(board.columns - 1, board.rows - 1);
  return print;
}

/// Prints the board as Kalibr does, rows counted from below and squares between tags, or from above and without.
inline Print print_of(const TagBoard& board, bool as_kalibr) {
  const int bits = as_kalibr ? 10 : 8;
  constexpr int bit = 12;
  const int tag = bits * bit;
  const int gap = static_cast<int>(std::lround(tag * board.gap_m / board.tag_m));
  const int margin = 2 * gap + bit;
  Print print;
  print.pixels_per_m = tag / board.tag_m;
  const auto extent = [&](int count) { return count * (tag + gap) - gap + 2 * margin; };
  print.grey = cv::Mat(extent(board.rows), extent(board.columns), CV_8U, cv::Scalar(235));
  const auto family = cv::aruco::getPredefinedDictionary(cv::aruco::DICT_APRILTAG_36h11);
  for (int row = 0; row < board.rows; ++row) {
    for (int column = 0; column < board.columns; ++column) {
      cv::Mat drawn;
      const int id = (as_kalibr ? board.rows - 1 - row : row) * board.columns + column;
      cv::aruco::drawMarker(family, id, tag, drawn, as_kalibr ? 2 : 1);
      drawn.copyTo(print.grey(cv::Rect(margin + column * (tag + gap), margin + row * (tag + gap), tag, tag)));
    }
  }
  for (int row = 0; as_kalibr && row <= board.rows; ++row)
    for (int column = 0; column <= board.columns; ++column)
      print.grey(cv::Rect(margin + column * (tag + gap) - gap, margin + row * (tag + gap) - gap, gap, gap)) = 20;
  print.origin_px = Eigen::Vector2d::Constant(margin);
  print.middle_m = Eigen::Vector2d(extent(board.columns), extent(board.rows)) / (2.0 * print.pixels_per_m) -
                   Eigen::Vector2d::Constant(margin / print.pixels_per_m);
  return print;
}

/// Renders the print as the camera sees it; each pixel is the mean of 2 x 2 rays.
inline Image view_of(const Print& print, const CameraModel& camera, const Pose3& camera_from_board, Random& random) {
  const Pose3 board_from_camera = camera_from_board.inverse();
  const Eigen::Vector3d& eye = board_from_camera.translation;
  auto pixels = std::make_shared<Bytes>();
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      double sum = 0.0;
      for (const auto& [right, down] : {std::pair{-0.25, -0.25}, {0.25, -0.25}, {-0.25, 0.25}, {0.25, 0.25}}) {
        const Eigen::Vector2d at(u + right, v + down);
        const Eigen::Vector3d ray = board_from_camera.rotation * normalised_from_pixel(camera, at).homogeneous();
        const Eigen::Vector3d hit = eye - eye.z() / ray.z() * ray;
        const Eigen::Vector2d on_print = print.origin_px + print.pixels_per_m * hit.head<2>();
        const int x = static_cast<int>(std::floor(on_print.x()));
        const int y = static_cast<int>(std::floor(on_print.y()));
        const bool inside =
            -eye.z() / ray.z() > 0.0 && x >= 0 && y >= 0 && x < print.grey.cols && y < print.grey.rows;
        sum += inside ? print.grey.at<std::uint8_t>(y, x) : 110.0;
      }
      pixels->push_back(static_cast<std::uint8_t>(std::clamp(sum / 4.0 + 2.0 * random.normal(), 0.0, 255.0)));
    }
  }
  return {camera.width, camera.height, std::move(pixels)};
}

/// Returns camera_from_board of a board held `distance_m` away, its middle at that pixel, tilted about the image's x
/// and y and turned about its axis.
inline Pose3 held(const Print& print, const CameraModel& camera, const Eigen::Vector2d& pixel, double distance_m,
                  double tilt_x_rad, double tilt_y_rad, double turn_rad) {
  Pose3 camera_from_board;
  camera_from_board.rotation = Eigen::AngleAxisd(tilt_x_rad, Eigen::Vector3d::UnitX()) *
                               Eigen::AngleAxisd(tilt_y_rad, Eigen::Vector3d::UnitY()) *
                               Eigen::AngleAxisd(turn_rad, Eigen::Vector3d::UnitZ());
  const Eigen::Vector3d middle(print.middle_m.x(), print.middle_m.y(), 0.0);
  camera_from_board.translation =
      distance_m * normalised_from_pixel(camera, pixel).homogeneous() - camera_from_board.rotation * middle;
  return camera_from_board;
}

}  // namespace weft::agents::test
