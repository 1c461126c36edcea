#pragma once
#include <Eigen/Core>
#include <string>
#include <vector>

#include "agents/perception/calibration/board.hpp"
#include "agents/perception/camera_model.hpp"
#include "core/camera/camera_file.hpp"
#include "core/result.hpp"

namespace weft::agents {

/// Holds the board as one image shows it.
struct BoardImage {
  std::string name;
  Sighting sighting;
};

struct CameraFitConfig {
  LensModel lens = LensModel::radtan;
  std::size_t fewest_images = 6;   ///< that show the board and agree
  double least_cover = 0.4;        ///< of the image's area that the board was in
  double least_tilt_rad = 0.26;    ///< between the two attitudes of the board that differ most
  double most_focal_share = 0.01;  ///< one sigma of the focal length; more says that the poses do not tell it
  double outlier_times = 2.5;      ///< an image whose RMS is so many times the median of the others disagrees...
  double outlier_px = 0.5;         ///< ...if it is as much as this
  double most_outlier_share = 1.0 / 3.0;
  double most_rms_px = 2.0;  ///< of all; more says that the board is not what it was said to be
};

struct ImageFit {
  std::string name;
  bool used = true;     ///< false: disagrees with the others, and was left out
  double rms_px = 0.0;  ///< of reprojection, with the final calibration
  std::vector<Eigen::Vector2d> pixels;
  std::vector<Eigen::Vector2d> error_px;  ///< seen minus predicted, of each pixel
};

struct CameraFit {
  CameraCalibration camera;  ///< without a mount; sigma.focal_share is set
  double rms_px = 0.0;       ///< of the images that were used
  double cover = 0.0;        ///< share of the image's area that the board was in
  double tilt_rad = 0.0;     ///< between the two attitudes that differ most
  std::vector<ImageFit> images;
};

/// Finds intrinsics from views of one flat board (Zhang 2000, as OpenCV's calib3d does it: k1 k2 p1 p2, or k1 k2 k3
/// k4 of the equidistant model), without images that disagree. The focal length's sigma is from the residuals.
/// refused: too few images, one attitude, too little of the image covered, a focal length that is not determined, a
/// board that is not as stated; the message names what, the bound, and what to do.
Result<CameraFit> fit_camera(const std::vector<BoardImage>& images, int width, int height,
                             const CameraFitConfig& config);

}  // namespace weft::agents
