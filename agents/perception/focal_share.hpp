#pragma once
#include <optional>
#include <vector>

#include "agents/perception/hamming.hpp"
#include "agents/perception/upright_features.hpp"

namespace weft::agents {

/// Holds the share by which a robot's focal length exceeds another camera's, beyond what is stated of both.
struct FocalShare {
  double share = 0.0;
  double variance = 0.0;
};

/// Describes a view that the other camera took, and which of its features the robot's view shows too.
struct OtherView {
  double ahead_m = 0.0;  ///< of the robot's, along the way of both, roughly
  const std::vector<UprightFeature>* features = nullptr;
  const std::vector<Match>* same = nullptr;  ///< a: of the other view; b: of the robot's
};

/// Estimates the focal share from tangents of elevation: those of a thing grow as its distance shrinks, by more the
/// nearer it stands; a larger focal length grows all of them alike. Least squares (Gauss-Newton, Tukey's biweight)
/// for the share, how far along the robot is, the pitch against each view, and the distance of each thing, 1 to 10 m
/// unless views show otherwise. Pixels are from the image's middle, of cameras stated to have `focal_px`. The fit
/// holds this as right to 2 %; the result is by the views alone, without that prior. None: fewer than 20 matches,
/// views that tell hardly anything, a fit that does not settle, or a share above a tenth.
std::optional<FocalShare> focal_share_of(const std::vector<OtherView>& views, const std::vector<UprightFeature>& seen,
                                         double focal_px);

}  // namespace weft::agents
