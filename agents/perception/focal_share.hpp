#pragma once
#include <optional>
#include <vector>

#include "agents/perception/hamming.hpp"
#include "agents/perception/upright_features.hpp"

namespace weft::agents {

/// The share by which a robot's focal length is larger than that of another camera, beyond what is stated of both.
struct FocalShare {
  double share = 0.0;
  double variance = 0.0;
};

/// A view that the other camera took, and what of it the robot's view shows too.
struct OtherView {
  double ahead_m = 0.0;  ///< of the robot's, along the way of both, roughly
  const std::vector<UprightFeature>* features = nullptr;
  const std::vector<Match>* same = nullptr;  ///< a: of the other view; b: of the robot's
};

/// Tangents of elevation of a thing grow as its distance shrinks, by more the nearer it stands; a larger focal length
/// grows all of them alike. Least squares (Gauss-Newton, Tukey's biweight) for that share, how far along the robot
/// is, the pitch against each view, and the distance of each thing, which is 1 to 10 m unless views show otherwise.
/// Pixels are from the image's middle, of cameras that are said to be of `focal_px`. While it is looked for, what is
/// said is held to be right to 2 %; what is returned is without that, by these views alone. None: hardly anything is
/// told, or more than a tenth.
std::optional<FocalShare> focal_share_of(const std::vector<OtherView>& views, const std::vector<UprightFeature>& seen,
                                         double focal_px);

}  // namespace weft::agents
