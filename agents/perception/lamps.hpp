#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "agents/perception/view.hpp"

namespace weft::agents {

struct LampConfig {
  int white_grey = 250;  ///< from there on a pixel is a lamp's
  int rim_px = 3;        ///< a corner so near to a lamp's rim is the rim's
  int bloom_px = 9;      ///< >= rim_px; so far out a lamp's light spreads over what is beside it
};

/// Finds the lamps that an image shows so bright that it is white there, and sorts its pixels by them.
class Lamps {
 public:
  /// Takes a whole image (`is_whole`).
  Lamps(const Image& image, const LampConfig& config);

  /// Returns whether a corner at that pixel is one of something: of a lamp's rim, or not near a lamp. Within a lamp
  /// nothing is seen, and close around it what seems to be there is its bloom.
  bool counts(const Eigen::Vector2d& pixel) const;

 private:
  enum class Part : std::uint8_t { beside, rim, bloom, inside };
  int width_ = 0;
  int height_ = 0;
  std::vector<Part> parts_;
};

/// Returns the mean grey value of what is no lamp, bloom left out; 255 where there is nothing else. The image is
/// whole.
double grey_beside_lamps(const Image& image, const LampConfig& config);

}  // namespace weft::agents
