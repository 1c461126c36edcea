#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "agents/methods/floor/floor.hpp"
#include "agents/perception/overlap.hpp"
#include "clients/evaluate/floor/attempts/tally.hpp"
#include "clients/evaluate/floor/drive.hpp"
#include "core/random.hpp"
#include "core/result.hpp"

namespace weft::evaluate::floor {

/// Holds a view or a place, and the floor that it shows.
struct Shows {
  agents::FloorContent content;
  Pose2 site_from_robot;  ///< truth
  agents::SeenPlane floor;
  Eigen::Vector2d middle;  ///< of its footprint, robot frame
};
/// Works out which floor a content shows, up to `far_m` ahead.
Shows shows_of(agents::FloorContent content, const Pose2& site_from_robot, double far_m);

/// Returns the share of b's image whose floor a sees too, [0, 1].
double shared(const Shows& a, const Shows& b);
Apart apart(const Shows& a, const Shows& b);

/// Holds the places that were taught, decoded once, with their truth.
class KnownPlaces {
 public:
  struct Known {
    PlaceId id;
    Shows shows;
    agents::Signature signature;
  };

  /// Decodes and signs all places. corrupt: a content that the method cannot read.
  static Result<KnownPlaces> make(const Taught& taught, const agents::Floor& method);

  const std::vector<Known>& all() const { return all_; }
  std::vector<std::size_t> that_share(const Shows& view, double least) const;
  std::vector<std::size_t> that_share_nothing(const Shows& view) const;
  /// Returns one of some places: that with the nearest signature but for a few, which is drawn.
  std::size_t alike(const std::vector<std::size_t>& some, const agents::Signature& signature, Random& random) const;

 private:
  std::vector<Known> all_;
};

/// Draws a pose for a robot so that it looks about where a place looked: the middle of its view up to `most_m` off,
/// headed anywhere, clear of boxes by its own radius. None: there is no room.
std::optional<Pose2> spot_near(const Shows& place, const agents::sim::Site& site, double most_m, Random& random);

}  // namespace weft::evaluate::floor
