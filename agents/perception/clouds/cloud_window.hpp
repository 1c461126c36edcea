#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "agents/perception/clouds/framed_cloud.hpp"
#include "core/geometry/pose3.hpp"

namespace weft::agents {

struct CloudWindowConfig {
  std::size_t frames = 8;      ///< most, [2, 32]
  double spacing_m = 0.12;     ///< a frame is taken this far from the last one,
  double spacing_rad = 0.175;  ///< or turned by this much
  double voxel_m = 0.05;
  /// Sets how many frames must have hit a voxel, or all where there are fewer: pixels that fly between two surfaces
  /// hardly meet twice, but a robot that stands has one frame alone.
  unsigned least_frames = 2;
  double most_blind_m = 0.3;  ///< frames from before a longer blind stretch are dropped
};

/// Holds what one stereo frame saw.
struct SeenFrame {
  Pose3 odometry_from_robot;
  std::vector<Eigen::Vector3f> points_in_robot;  ///< one that is not finite met nothing
  Eigen::Vector3f camera_in_robot = Eigen::Vector3f::Zero();
  std::uint64_t clear_bearings = 0;  ///< a bit for each part of its view in which nothing stood within range
};

/// Holds the points around a place, each with the index of the frame that saw it from nearest. In the place's frame.
struct PlaceCloud {
  std::vector<Eigen::Vector3f> points;
  std::vector<std::uint16_t> frames;
  std::vector<Pose3> place_from_frames;            ///< where the robot stood
  std::vector<Eigen::Vector3f> cameras;            ///< where each frame's camera stood
  std::vector<std::uint64_t> clear_bearings = {};  ///< of each frame, as in SeenFrame; empty: nobody says

  FramedCloud framed(const DepthNoise& noise) const { return {points, frames, cameras, noise}; }
};

/// Keeps the clouds of the last frames (Dayoub et al. 2013, III-A, fig. 3), placed by odometry.
class CloudWindow {
 public:
  CloudWindow(const CloudWindowConfig& config, const DepthNoise& noise) : config_(config), noise_(noise) {}

  /// Takes a frame, unless the robot has hardly moved since the last. Returns whether it was taken.
  bool add(SeenFrame frame);
  /// Notes that the robot went so far without seeing: what was seen before may not fit what comes.
  void go_blind(double metres);
  std::size_t size() const { return frames_.size(); }

  /// Returns the points about a place: one a voxel, the mean of its points weighed by their depth noise.
  PlaceCloud snapshot(const Pose3& odometry_from_place) const;

 private:
  CloudWindowConfig config_;
  DepthNoise noise_;
  std::deque<SeenFrame> frames_;  // oldest first
  double blind_m_ = 0.0;          // since a frame was last seen
};

}  // namespace weft::agents
