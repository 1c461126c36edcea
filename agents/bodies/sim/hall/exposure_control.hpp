#pragma once
#include "agents/bodies/sim/site.hpp"

namespace weft::agents::sim {

/// A camera that makes its image as bright as it is told by exposing longer, and where that blurs too much, by
/// amplifying: noise grows with it.
class ExposureControl {
 public:
  ExposureControl(const ForwardCameraSetup& setup, double exposure_s);

  double exposure_s() const;  ///< now
  double amplified() const;   ///< >= 1
  /// Grey levels of an image for what would be 1 at the exposure that sites are lit for.
  double gain() const { return asked_; }
  /// `mean_light`: of the image just taken, what its grey levels would be at gain 1.
  void taken(double mean_light);

 private:
  ForwardCameraSetup setup_;
  double nominal_s_;
  double asked_ = 1.0;
};

}  // namespace weft::agents::sim
