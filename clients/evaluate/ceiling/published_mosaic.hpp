#pragma once
#include <Eigen/Core>
#include <cstddef>

#include "agents/perception/camera_model.hpp"
#include "agents/perception/corner_tracks.hpp"
#include "agents/perception/view.hpp"

namespace weft::evaluate::ceiling {

/// Is the mosaic as Lucas et al. publish it, as a baseline: Harris corners (II.B), a homography between consecutive
/// images by random sampling (II.C), homographies composed image by image (II.D), the robot in the middle of the
/// image (III). The lens is undone, which they do not need. They do not say how corners are paired: they are
/// followed by Lucas & Kanade.
class PublishedMosaic {
 public:
  explicit PublishedMosaic(const agents::CameraModel& camera) : camera_(camera) {}

  /// Joins the next image. One that cannot be joined is taken for the one before. The image is whole and of the
  /// camera's size.
  void add(const agents::Image& image);

  /// Returns where the robot is since the first image, in distances from the camera to the ceiling: ahead and left of
  /// where it stood then, by its mount.
  Eigen::Vector2d robot_in_start() const;
  std::size_t not_joined() const { return not_joined_; }

 private:
  /// Returns the middle of the image's four corners, laid in the mosaic (III).
  Eigen::Vector2d centroid() const;

  agents::CameraModel camera_;
  agents::TrackingImage newest_;
  Eigen::Matrix3d mosaic_from_image_ = Eigen::Matrix3d::Identity();  ///< normalised coordinates
  Eigen::Vector2d first_centroid_ = Eigen::Vector2d::Zero();
  std::size_t not_joined_ = 0;
};

}  // namespace weft::evaluate::ceiling
