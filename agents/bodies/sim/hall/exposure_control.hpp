#pragma once
#include <optional>

#include "agents/bodies/sim/site.hpp"
#include "agents/perception/view.hpp"

namespace weft::agents::sim {

/// Controls the exposure of a camera that makes its image as bright as it is told by exposing longer, and beyond its
/// longest time by amplifying: noise grows with it. While somebody tells it how to expose it does that instead.
class ExposureControl {
 public:
  ExposureControl(const ExposureSetup& setup, double exposure_s);

  /// Says that an image is about to be taken.
  void comes(double time_s);
  double exposure_s() const;  ///< now
  double amplified() const;   ///< >= 1
  /// Returns the grey levels of an image for what would be 1 at the exposure that sites are lit for.
  double gain() const { return told_ ? told_->light_s() / lit_for_s() : asked_; }
  /// Returns the present exposure as agents are told it.
  Exposure now() const;
  /// Follows the image just taken. `mean_light`: what its mean grey level would be at gain 1.
  void taken(double mean_light);
  /// Sets the exposure from the next image on, within what the camera can. False: it exposes as the site is lit for,
  /// whatever the light.
  bool tell(const Exposure& exposure);

 private:
  double lit_for_s() const;

  ExposureSetup setup_;
  double nominal_s_;
  double asked_ = 1.0;
  std::optional<Exposure> told_;
  double now_s_ = 0.0;
  double told_at_s_ = 0.0;
};

}  // namespace weft::agents::sim
