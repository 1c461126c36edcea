#pragma once
#include <functional>
#include <string>
#include <vector>

#include "agents/bodies/replay/recording.hpp"
#include "agents/perception/camera_model.hpp"
#include "core/result.hpp"

namespace weft::agents::replay {

/// Holds one half of a rectified pair as KITTI's odometry benchmark records it.
struct KittiCamera {
  CameraModel model;  ///< no lens; `robot_from_camera` is where it is beside the left one
  std::vector<RecordedImage> images;
};

/// Returns whether that folder is laid out so: holds calib.txt and image_l/ (image_r/ is not looked for).
bool is_kitti(const std::string& folder);

/// Reads image_l (P0 of calib.txt) or image_r (P1). Images are numbered by their names from 0, so that one
/// that is missing leaves its other half alone. Times are those of times.txt, seconds a row, the first of image 0;
/// without the file ten images a second, which is warned of. not_found: there is no such half; invalid: names the
/// file, and the line.
Result<KittiCamera> read_kitti(const std::string& folder, const std::string& half,
                               const std::function<void(const std::string&)>& warn);

/// Describes the projection of a rectified camera, 3 x 4 row by row on a line "P0: 12 numbers"; without names lines
/// are P0, P1, ... in order. not_found: no such line; invalid: it has not 12 numbers, or is of no rectified camera.
struct Projection {
  double focal_px = 0.0, cx = 0.0, cy = 0.0;
  double baseline_m = 0.0;  ///< to the right of the left camera
};
Result<Projection> parse_projection(const std::string& text, const std::string& file, int number);

}  // namespace weft::agents::replay
