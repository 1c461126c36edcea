#pragma once
#include <vector>

#include "agents/perception/calibration/board.hpp"
#include "agents/perception/camera_model.hpp"

namespace weft::agents {

/// Returns the share of the image's area that lies within the board's points of any image, [0, 1].
double cover_of(const std::vector<Sighting>& sightings, int width, int height);

/// Returns the largest angle between the board's normals of two images, rad, [0, pi / 2].
double widest_tilt(const std::vector<Pose3>& camera_from_board);

/// Returns how well images determine the mean focal length, the optical centre (the worse of its two coordinates) and
/// the lens: the covariance of least squares over intrinsics and all poses, scaled by the residuals. Infinite when
/// the images leave something undetermined. The mount is not looked at.
CalibrationSigma intrinsics_sigma(const CameraModel& camera, const std::vector<Pose3>& camera_from_board,
                                  const std::vector<Sighting>& sightings);

}  // namespace weft::agents
