#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "agents/adjustment/mosaic.hpp"

namespace weft::agents {

/// Describes how places of a mosaic that follow one another lie to the first of them, by what was sighted from these
/// places alone.
struct WindowFit {
  std::uint32_t first = 0;
  std::vector<Pose2> first_from_place;  ///< the first one's own is the identity
  std::vector<Attitude> attitudes;
  /// Is the information on xi, three of each place but the first, in first_from_place * se2_exp(xi).
  Eigen::MatrixXd information;
};

/// Holds the sightings and links of a mosaic by where windows look for them.
class MosaicIndex {
 public:
  explicit MosaicIndex(const Mosaic& mosaic);
  const std::vector<std::uint32_t>& sightings_from(std::uint32_t place) const { return of_place_[place]; }
  const std::vector<std::uint32_t>& sightings_of(std::uint32_t point) const { return of_point_[point]; }
  /// Returns the links without the stitches.
  const std::vector<std::uint32_t>& links_from(std::uint32_t place) const { return links_[place]; }

 private:
  std::vector<std::vector<std::uint32_t>> of_place_;
  std::vector<std::vector<std::uint32_t>> of_point_;
  std::vector<std::vector<std::uint32_t>> links_;
};

/// Adjusts the places [first, first + count) and the points that two or more of them see, from where the mosaic has
/// them: bundle adjustment in the plane, with an attitude for each place and the links between them; Huber's loss.
WindowFit fit_window(const Mosaic& mosaic, const MosaicIndex& index, std::uint32_t first, std::uint32_t count);

}  // namespace weft::agents
