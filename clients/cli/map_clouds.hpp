#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "clients/cli/mosaic.hpp"
#include "core/network/window.hpp"
#include "core/result.hpp"
#include "storage/formats/cloud.hpp"
#include "storage/formats/network_export.hpp"

namespace weft::cli {

/// Lays the clouds of a network's places together: which contents are clouds, and where their points lie once the
/// contents are there. The methods say so themselves (agents/methods/all.hpp).
class MapClouds {
 public:
  static constexpr double kVoxelM = 0.05;  ///< one point is kept of each cube with this edge, of each experience

  /// `frame_from_place`: where places lie; one that lies nowhere is left out. Both outlive this.
  MapClouds(const Window& network, const formats::Poses& frame_from_place);

  /// Returns the contents that are clouds. refused: no place was made by a method whose contents are; names those.
  Result<std::vector<ContentRef>> wanted() const;

  /// Takes a content's points. corrupt, newer: it is no cloud that this program reads.
  Result<void> take(const ContentHash& hash, ByteView bytes);

  /// Returns how many places have given their points.
  std::size_t places() const { return places_; }
  /// Returns all points, metres, z above the floor, with the number of their experience, from 0 in the order of the
  /// network, as intensity.
  formats::Cloud cloud() const;

 private:
  struct Laid {
    std::vector<Eigen::Vector3f> points;
    std::size_t thinned_to = 0;
  };

  const Window& network_;
  const formats::Poses& frame_from_place_;
  std::multimap<ContentHash, PlaceId> places_of_;
  std::map<ExperienceId, Laid> laid_;
  std::size_t places_ = 0;
};

/// Draws points as seen from above, in cells of `cell_m` or as coarse as makes 16 million pixels: dark where
/// something stands at a robot's height, the darker the more points, pale where there is floor. There is at least one
/// point.
Mosaic from_above(const std::vector<Eigen::Vector3f>& points, double cell_m);

}  // namespace weft::cli
