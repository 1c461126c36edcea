#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "agents/perception/camera_model.hpp"
#include "agents/perception/plane/feature.hpp"
#include "agents/perception/view.hpp"

namespace weft::agents {

/// Bounds the stretch of a plane that is rectified, robot frame: ahead of the robot or about it, below the camera or
/// above it. Row 0 is the farthest, column 0 the leftmost, as seen from above: a ceiling is mirrored.
struct BirdsEyeArea {
  double far_m = 1.5;
  double half_width_m = 0.9;
  double metres_per_pixel = 0.003;
  double near_m = -std::numeric_limits<double>::infinity();  ///< and no nearer than what the camera sees
  double above_floor_m = 0.0;                                ///< of the plane
  /// Grey levels as seen, before they are equalised: a corner about which their standard deviation is no more is the
  /// pixels' noise and is left out; 0: none is.
  double least_contrast = 0.0;
};

struct PlanePatch {
  int width = 0;
  int height = 0;
  double metres_per_pixel = 0.0;
  Eigen::Vector2d first_pixel_on_plane = Eigen::Vector2d::Zero();
  std::vector<std::uint8_t> pixels;  ///< equalised grey; 0 where the camera does not see
};

/// Holds the stretch of a plane that one view shows, rectified.
struct RectifiedPlane {
  std::vector<PlaneFeature> features;
  PlanePatch patch;
};

/// Rectifies the views of one camera to a plane as its mount sees it (its lens undone), filtered by area where the
/// image is finer than the map. The tables are made once; the object is immutable and cheap to copy.
class BirdsEye {
 public:
  BirdsEye(const CameraModel& camera, const BirdsEyeArea& area);

  /// Returns the rectified view: grey values equalised (contrast-limited, in tiles: lamps and shadows change
  /// brightness locally), then at most `count` oriented binary features spread over the area, and the patch at
  /// `patch_metres_per_pixel`. The image is whole and of the camera's size.
  RectifiedPlane rectify(const Image& image, int count, double patch_metres_per_pixel) const;

 private:
  struct Tables;
  std::shared_ptr<const Tables> tables_;
};

}  // namespace weft::agents
