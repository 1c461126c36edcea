#pragma once
#include <vector>

#include "agents/perception/focal_share.hpp"
#include "core/ids.hpp"

namespace weft::agents {

/// What a robot knows of the focal lengths of those that taught: a run is taught with one camera, and nobody has
/// measured it, nor its own. A value.
class OtherCameras {
 public:
  /// `sigma`: of a share of which nothing has been seen yet.
  FocalShare of(const ExperienceId& run, double sigma) const;
  void moved(double metres);
  /// Whether another word of that run's is worth asking for: views from nearly one spot show the same things, and err
  /// alike.
  bool is_due(const ExperienceId& run) const;
  /// By one view; `sigma` as above.
  void told(const ExperienceId& run, const FocalShare& by_view, double sigma);

 private:
  struct Known {
    ExperienceId run;
    FocalShare share;
    double since_m = 0.0;
  };
  const Known* find(const ExperienceId& run) const;

  std::vector<Known> known_;
};

}  // namespace weft::agents
