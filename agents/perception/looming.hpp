#pragma once
#include <optional>
#include <vector>

#include "agents/perception/hamming.hpp"
#include "agents/perception/upright_features.hpp"

namespace weft::agents {

/// Describes the looming between two views: the share by which the second shows things nearer to its camera than the
/// first, and how much it is turned against the first.
struct Looming {
  double share = 0.0;  ///< of their distance; positive: the second view is taken from further ahead
  double variance = 0.0;
  double turned_rad = 0.0;  ///< the second camera, to the left
  double turned_variance_rad2 = 0.0;
  double pitch = 0.0;       ///< by which tangents of elevation have grown (downwards) beside that
  double spread_rad = 0.0;  ///< standard deviation of single features about the turn: of a view from aside things
                            ///< near and far have moved by different angles
};

/// Estimates looming from how far features that both views show (`same`) have moved away from the horizon: tangents
/// of elevation, y / sqrt(f^2 + x^2), stay as they are when a camera turns and grow as its distance shrinks. Pixels
/// are from the image's middle, of cameras of `focal_px`. By robust least squares (Tukey's biweight) together with
/// the pitch between both; then the turn, as the mean of what azimuths have changed by beside that. None: too few, or
/// all at one height.
std::optional<Looming> looming_of(const std::vector<UprightFeature>& a, const std::vector<UprightFeature>& b,
                                  const std::vector<Match>& same, double focal_px);

}  // namespace weft::agents
