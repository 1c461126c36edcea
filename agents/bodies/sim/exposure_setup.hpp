#pragma once

namespace weft::agents::sim {

/// Describes how a camera that looks around in a hall exposes itself.
struct ExposureSetup {
  bool exposes_itself = true;
  double mean_grey = 110.0;          ///< that it exposes for
  double longest_exposure_s = 0.02;  ///< from there on it amplifies
  double most_gain = 40.0;
};

}  // namespace weft::agents::sim
