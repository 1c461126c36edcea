#pragma once
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "agents/methods/dead_reckoning.hpp"
#include "agents/methods/method.hpp"

namespace weft::agents {

/// Holds numbered marks as a noisy sensor saw them; in a view they are its payload.
struct Marks {
  struct Sighting {
    std::uint64_t mark = 0;
    Pose2 robot_from_mark;
  };
  std::vector<Sighting> sightings;

  operator Payload() const;  // NOLINT(google-explicit-constructor): `view.data = marks`
};
/// Returns the marks of a view; none: it is of another sensor.
std::optional<Marks> marks_of(const View& view);

struct MarksConfig {
  double position_sigma_m = 0.005;  ///< of one sighting; (0, 0.2]
  double heading_sigma_rad = 0.01;  ///< of one sighting; (0, 0.5]
  double agree_m = 0.08;            ///< sightings of one mark agree within this; (0, 1]
  double agree_rad = 0.15;          ///< (0, 1]
  double least_share = 0.6;         ///< of the common marks must agree; [0.5, 1]
  double most_distance_m = 3.0;     ///< between two related views; (0, 20]
  DeadReckoningConfig blind;
  MotionGate gate;  ///< of one step of odometry
};
/// Returns an error for every bound that the configuration does not keep.
std::vector<Error> check(const MarksConfig& config);

/// Is the test-only method: numbered marks at noisy poses. A content lists the marks seen; two contents are related
/// by the motion that most of their common marks agree on. Wrong sightings (one number in two places) are outvoted.
class MarksMethod {
 public:
  static constexpr std::string_view name = "marks";
  static constexpr std::uint32_t content_format = 1;
  using Sighting = Marks::Sighting;
  /// Holds the marks that were seen, sorted by mark, each once.
  struct Content {
    std::vector<Sighting> sightings;
  };
  struct Odometry {
    Content last;
    Metric2 last_from_now;  ///< integrated blindly since `last`
  };

  explicit MarksMethod(const MarksConfig& config = {}) : config_(config) {}

  /// Infers the motion since the last view. Seen: common marks of the last two views agree. Blind: "no_view",
  /// "disagrees_with_wheels", "disagrees_with_command", or what relate refused for.
  Step observe(Odometry& odometry, const View* view, const Motion& motion) const;
  /// Returns the marks of a view. Refused: "no_marks", "not_marks" (another sensor's view).
  OrRefusal<Content> extract(const Odometry& odometry, const View& view) const;
  /// Writes, little-endian: count of sightings (u64, at most 10000), then of each its mark (u64, increasing) and x, y
  /// (m) and heading (rad) of robot_from_mark (f64, finite). Nothing may follow.
  Bytes encode(const Content& content) const;
  Result<Content> decode(ByteView bytes) const;
  /// Relates two contents by their common marks. Refused: "few_marks", "inconsistent_marks", "too_far_apart".
  OrRefusal<Related> relate(const Content& a, const Content& b, const std::optional<Relation>& guess) const;
  /// Returns a histogram of mark numbers in 32 bins, of unit length; none without marks.
  std::optional<Signature> sign(const Content& content) const;
  /// Returns the middle of the marks seen, in the robot's frame: it lies ahead of the robot.
  Eigen::Vector2d gaze(const Content& content) const;

 private:
  MarksConfig config_;
};

}  // namespace weft::agents
