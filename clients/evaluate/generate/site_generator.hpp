#pragma once
#include <cstdint>
#include <map>
#include <vector>

#include "core/bytes.hpp"
#include "core/geometry/pose2.hpp"
#include "core/network/change.hpp"
#include "core/random.hpp"

namespace weft {

/// Describes a warehouse that robots have driven in for long, to see how what is built for a site bears a large one.
struct SitePlan {
  std::uint64_t places = 10'000;  ///< [1, 10,000,000]
  std::uint64_t seed = 1;
  std::uint32_t content_bytes = 64;  ///< of each place's content, [8, 1,000,000]
  std::uint32_t batch_places = 500;  ///< [1, kBatchPlaces]
  std::uint32_t runs_a_corridor =
      16;  ///< how often a corridor is driven through in the end, both directions together
};
/// Checks a plan. invalid: names the number and its bounds.
Result<void> check(const SitePlan& plan);

/// Generates aisles of 40 m between cross aisles, 4 m apart. Experiences of 200 to 3000 places, 0.2 to 0.3 m apart,
/// keep to the right and turn where they like; every second place is stitched to an older one beside it, one stitch
/// in ten to one of the other direction, which cannot be driven. Stations at the crossings are labelled. The same
/// plan gives the same batches, which fit an empty network one after the other.
class SiteGenerator {
 public:
  /// Begins a site by a plan that has been checked.
  explicit SiteGenerator(const SitePlan& plan);

  bool is_done() const { return made_ == plan_.places; }
  std::uint64_t made() const { return made_; }
  Batch next();
  /// Returns where the places of the last batch truly lie: site_from_place.
  const std::vector<Pose2>& poses() const { return poses_; }
  /// Returns bytes that compress to about half, a place's own.
  Bytes content(const PlaceId& place) const;
  /// Returns the labels of stations that lie in what was made so far; complete when done.
  const std::map<std::string, PlaceId>& labels() const { return labels_; }

 private:
  struct Crossing {
    int column = 0;
    int row = 0;
    bool operator==(const Crossing&) const = default;
  };
  struct Seen {
    PlaceId place;
    Pose2 site_from_place;
  };

  void begin_experience();
  void choose_turn();
  void advance();
  void add_place(Batch& batch);
  void add_stitch(Batch& batch, const PlaceId& place);
  std::size_t bin(int along_bin, int direction) const;
  Pose2 site_from_robot() const;

  SitePlan plan_;
  Random random_;
  int columns_ = 1;
  int rows_ = 1;
  std::uint64_t made_ = 0;
  std::map<std::string, PlaceId> labels_;
  std::vector<std::vector<Seen>> seen_;  ///< by direction and stretch of a corridor

  ExperienceId experience_;
  RobotId robot_;
  std::uint64_t sequence_ = 0;
  std::uint32_t index_ = 0;   ///< of the next place
  std::uint32_t length_ = 0;  ///< of the experience; 0: none is under way
  double spacing_m_ = 0.25;
  double aside_m_ = 0.5;
  Crossing from_;
  Crossing to_;
  double along_m_ = 0.0;  ///< from one crossing to the next
  Pose2 last_;
  std::vector<Pose2> poses_;
};

}  // namespace weft
