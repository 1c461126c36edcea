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

/// A view or a place, and the floor that it shows.
struct Shows {
  agents::FloorContent content;
  Pose2 site_from_robot;  ///< truth
  agents::SeenFloor floor;
  Eigen::Vector2d middle;  ///< of its footprint, robot frame
};
/// With the floor up to `far_m` ahead.
Shows shows_of(agents::FloorContent content, const Pose2& site_from_robot, double far_m);

/// Share of b's image whose floor a sees too.
double shared(const Shows& a, const Shows& b);
Apart apart(const Shows& a, const Shows& b);

/// What was taught, decoded once, with its truth.
class KnownPlaces {
 public:
  struct Known {
    PlaceId id;
    Shows shows;
    agents::Signature signature;
  };

  /// corrupt: a content that the method cannot read.
  static Result<KnownPlaces> make(const Taught& taught, const agents::Floor& method);

  const std::vector<Known>& all() const { return all_; }
  std::vector<std::size_t> that_share(const Shows& view, double least) const;
  std::vector<std::size_t> that_share_nothing(const Shows& view) const;
  /// Of some places the one whose signature is nearest but for a few, drawn.
  std::size_t alike(const std::vector<std::size_t>& some, const agents::Signature& signature, Random& random) const;

 private:
  std::vector<Known> all_;
};

/// Where to put a robot so that it looks about where a place looked: the middle of its view up to `most_m` off,
/// headed anywhere, clear of boxes by its own radius. None: there is no room.
std::optional<Pose2> spot_near(const Shows& place, const agents::sim::Site& site, double most_m, Random& random);

}  // namespace weft::evaluate::floor
