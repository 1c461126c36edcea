#pragma once
#include <memory>
#include <vector>

#include "agents/methods/ceiling/ceiling.hpp"
#include "clients/evaluate/ceiling/height_watch.hpp"
#include "clients/evaluate/ceiling/navigators.hpp"
#include "clients/evaluate/ceiling/published_mosaic.hpp"
#include "clients/evaluate/floor/trace.hpp"
#include "core/result.hpp"

namespace weft::evaluate::ceiling {

/// Watches a drive beside the robot's own navigator: the method as if all were one plane, the mosaic as published,
/// the heights that the method finds. One entry a sample, in the order of the drive's trace.
class DriveWatch {
 public:
  /// Makes the watch, with the errors of the method.
  static Result<std::shared_ptr<DriveWatch>> make(const agents::CeilingConfig& settings,
                                                  const agents::CameraModel& camera);

  /// Returns what the navigator's method is to be given. `watch` is kept alive by it.
  static Look look_of(const std::shared_ptr<DriveWatch>& watch);

  /// Describes a view that was put aside.
  struct Kept {
    std::size_t sample = 0;
    agents::Image image;
  };

  const std::vector<Pose2>& one_plane() const { return one_plane_; }  ///< start_from_robot
  const std::vector<Pose2>& mosaic() const { return mosaic_poses_; }  ///< likewise; no heading
  const HeightWatch& heights() const { return heights_; }
  const std::vector<Kept>& kept() const { return kept_; }  ///< a view each metre and a half
  const agents::CameraModel& camera() const { return flat_.camera(); }

 private:
  DriveWatch(agents::Ceiling whole, agents::Ceiling flat);
  void look(const agents::Ceiling::Odometry& odometry, const agents::View* view, const agents::Motion& motion);

  agents::Ceiling flat_;  ///< sees one plane
  agents::Ceiling::Odometry flat_odometry_;
  PublishedMosaic published_;
  HeightWatch heights_;
  double away_m_;  ///< from the camera up to the ceiling, as it is told
  std::vector<Pose2> one_plane_;
  std::vector<Pose2> mosaic_poses_;
  std::vector<Kept> kept_;
};

/// Returns the drive with another odometry, which has as many samples.
floor::Trace with_odometry(floor::Trace trace, const std::vector<Pose2>& start_from_robot);

}  // namespace weft::evaluate::ceiling
