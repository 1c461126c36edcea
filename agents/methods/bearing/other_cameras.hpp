#pragma once
#include <optional>
#include <vector>

#include "agents/perception/focal_share.hpp"
#include "core/ids.hpp"

namespace weft::agents {

/// Tells, by one view, of the camera that taught a run.
struct CameraLook {
  ExperienceId run;
  FocalShare share;
};

/// Tells, by one view, how many pixels lower it shows things than the camera that taught a run did: another one
/// stands higher, or looks further down.
struct CameraRise {
  ExperienceId run;
  double px = 0.0;
};

/// Keeps how the robot's focal length compares with those of the cameras that taught, as far as it is known: a run is
/// taught with one camera, and nobody has measured it, nor the robot's own. A value.
class OtherCameras {
 public:
  /// Returns the share by which the run's camera differs; `sigma`: 1 sigma of one of which nothing has been seen yet.
  FocalShare of(const ExperienceId& run, double sigma) const;
  void moved(double metres);
  /// Returns whether another word of that run's is worth asking for: views from nearly one spot show the same things,
  /// and err alike.
  bool is_due(const ExperienceId& run) const;
  /// Learns from one view; `sigma` as above. A difference that is larger than errors explain is cut to the largest
  /// that they explain.
  void told(const CameraLook& by_view, double sigma);

  /// Returns the median, in pixels, of what views have told of a run; none: too few have.
  std::optional<double> rise_px(const ExperienceId& run) const;
  void told(const CameraRise& by_view);

 private:
  struct Known {
    ExperienceId run;
    FocalShare share;
    double since_m = 0.0;
  };
  const Known* find(const ExperienceId& run) const;

  struct Risen {
    ExperienceId run;
    std::vector<double> by_px;  // sorted
  };

  std::vector<Known> known_;
  std::vector<Risen> risen_;
};

}  // namespace weft::agents
