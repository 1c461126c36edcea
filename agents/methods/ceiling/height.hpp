#pragma once
#include <optional>

#include "agents/methods/ceiling/config.hpp"
#include "agents/perception/camera_model.hpp"
#include "agents/perception/planar_motion.hpp"
#include "agents/perception/plane/feature.hpp"

namespace weft::agents {

/// Holds what has been told of a corner's height above the floor.
struct ToldHeight {
  double above_floor_m = 0.0;
  double information = 0.0;  ///< 1 over the variance; 0: nothing has been told
};
ToldHeight together(const ToldHeight& one, const ToldHeight& other);
/// Returns the same where all distances from the camera are longer by a factor.
ToldHeight scaled(const ToldHeight& told, double factor, double camera_m);

/// Says where corners may be: on the ceiling, or hanging below it, above the robot.
struct HeightPrior {
  double ceiling_m = 0.0;
  double flat_sigma_m = 0.02;  ///< of the ceiling itself
  double hangs_sigma_m = 0.8;  ///< how far things hang below it, mostly
  double lowest_m = 0.0;       ///< of what may be part of a ceiling
};
HeightPrior height_prior(const CeilingConfig& config, double ceiling_m, double camera_m);

struct Height {
  double above_floor_m = 0.0;
  double sigma_m = 0.0;
};
/// Moves a feature along its ray to a height.
void set_height(const CameraModel& camera, const Height& height, PlaneFeature& feature);

/// Returns a corner's height as the prior and what has been told have it: a mixture of one on the ceiling and one
/// that hangs below, with the variance of both. None: it is too high or too low to be part of a ceiling.
std::optional<Height> height_of(const HeightPrior& prior, const ToldHeight& told);
/// Returns how likely it is that the corner is one of the ceiling itself, [0, 1].
double likely_on_ceiling(const HeightPrior& prior, const ToldHeight& told);

/// Tells heights from what is left of tracks along the epipolar direction, for one motion between two views.
class HeightTeller {
 public:
  HeightTeller(const CameraModel& camera, const PlanarFit& fit, const HeightPrior& prior)
      : reproject_(camera, camera, fit.state),
        covariance_(fit.covariance),
        prior_(prior),
        camera_m_(camera.robot_from_camera.translation.z()),
        focal_px_(focal(camera)) {}

  /// Returns the height of a pair of points by itself, one dimension; no information where the motion shows none.
  ToldHeight told_by(const PlanePair& pair) const;

 private:
  static double focal(const CameraModel& camera);
  Reprojector reproject_;
  Matrix9d covariance_;
  HeightPrior prior_;
  double camera_m_;
  double focal_px_;
};

}  // namespace weft::agents
