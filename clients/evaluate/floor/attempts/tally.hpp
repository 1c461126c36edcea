#pragma once
#include <array>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "agents/methods/method.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::evaluate::floor {

/// Bounds how far a relation may be off and not be wrong.
inline constexpr double kWrongM = 0.10;
inline constexpr double kWrongRad = 3.0 * 0.017453292519943295;

/// Names what was attempted: two contents related as such, or a part of navigation that takes the relation or leaves
/// it. The names stand in the files.
namespace attempted {
inline constexpr const char* kNear = "near";                          ///< the floor seen is seen by the place too
inline constexpr const char* kNearGuided = "near, guided";            ///< with a guess as uncertain as it says
inline constexpr const char* kElsewhere = "elsewhere";                ///< floor that the place does not show
inline constexpr const char* kLookAlike = "look-alike";               ///< of that, what the signature takes for near
inline constexpr const char* kElsewhereGuided = "elsewhere, guided";  ///< with a guess that says it is here
inline constexpr const char* kWrongGuess = "near, wrong guess";       ///< the guess is farther off than it says
inline constexpr const char* kMirrored = "mirrored";       ///< the place's own floor, left and right changed
inline constexpr const char* kOtherFloor = "other floor";  ///< of the same kind
inline constexpr const char* kSeeking = "seeking";         ///< a robot that knows nothing, each view
inline constexpr const char* kSeekingOther = "seeking, other floor";
inline constexpr const char* kTracking = "tracking";  ///< a robot that knows where it is, each view
inline constexpr const char* kTrackingLost = "tracking, wrong belief";
inline constexpr const char* kStitching = "stitching";  ///< a place just kept
inline constexpr const char* kStitchingLost = "stitching, wrong belief";
}  // namespace attempted

/// Counts what attempts of one sort came to.
struct Outcomes {
  std::size_t right = 0;
  std::size_t wrong = 0;
  std::map<std::string, std::size_t> refused;  ///< by reason
  std::size_t all_refused() const;
  std::size_t attempts() const { return right + wrong + all_refused(); }
  void add(const Outcomes& other);
};

/// Describes one that is wrong, so that it can be looked into.
struct WrongOne {
  std::string sort;
  double off_m = 0.0;  ///< on another floor: not a number
  double off_rad = 0.0;
  Pose2 site_from_robot;   ///< where it was
  Pose2 site_from_place;   ///< what it was related to
  Pose2 place_from_robot;  ///< what was said
};

/// Counts attempts that have a right answer by how far apart the middles of what both see lie, and by how much their
/// headings differ.
struct Recall {
  static constexpr std::size_t kBins = 12;
  static constexpr double kBinM = 0.1;
  static constexpr double kBinRad = 15.0 * 0.017453292519943295;
  std::array<std::size_t, kBins> tried_by_metres{}, right_by_metres{}, tried_by_heading{}, right_by_heading{};
  void add(const Recall& other);
};

/// Tells how two views lay to each other.
struct Apart {
  double metres = 0.0;   ///< between the middles of what they see
  double radians = 0.0;  ///< [0, pi]
};

/// Holds all that came of one row's attempts. A value.
class Tally {
 public:
  /// Counts one. `truth`: place_from_robot; none: another floor. `site_from_place`: for looking into what is wrong.
  void count(const std::string& sort, const agents::OrRefusal<Pose2>& place_from_robot,
             const std::optional<Pose2>& truth, const Pose2& site_from_place);
  /// Counts one that has a right answer once more, for recall; to be called after `count`.
  void recall(const std::string& sort, const Apart& apart, bool is_right);
  void add(const Tally& other);

  std::size_t attempts() const;
  std::size_t wrong() const;

  std::map<std::string, Outcomes> sorts;
  std::map<std::string, Recall> recalls;  ///< kNear and kNearGuided
  std::vector<WrongOne> wrong_ones;
};

bool is_right(const Pose2& place_from_robot, const Pose2& truth);

}  // namespace weft::evaluate::floor
