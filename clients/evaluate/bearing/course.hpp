#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "agents/bodies/sim/sim_body.hpp"
#include "agents/methods/bearing/bearing.hpp"
#include "agents/navigation/navigator.hpp"
#include "clients/evaluate/exposed.hpp"
#include "clients/evaluate/taught_map.hpp"
#include "core/result.hpp"

namespace weft::evaluate::bearing {

/// Tells what of the method drives: all, what Krajnik et al. 2018 have of it (the distance is the wheels' alone), or
/// one half of that, which is their ablation (IV-B).
enum class Parts : std::uint8_t { all, heading_only, profile_only, vision_only };

/// Makes what an agent of this method would drive with.
Result<std::unique_ptr<agents::Navigator>> make_navigator(const agents::CameraModel& camera, Parts parts);

/// Holds a closed way that one robot has been taught, with its truth: for judging, nobody else sees it.
struct Course {
  TaughtMap map;
  std::vector<PlaceId> places;         ///< in the order they were taught
  std::vector<Pose2> site_from_place;  ///< truly
  std::vector<Relation> relations;     ///< of each place and the next; of the last and `closes_at`
  std::size_t closes_at = 0;           ///< where the end was found to come back to
  std::vector<double> along_m;         ///< of each place, from the first
  double length_m = 0.0;               ///< from the first to the last

  /// Returns the length of one round, from where the way closes.
  double round_m() const;
  /// Returns where the path truly is so far beyond a place.
  Pose2 site_from_path(std::size_t place, double beyond_m) const;
  /// Returns a route of so many rounds: first the whole way, later from where it closes; it ends there.
  Route loops(std::size_t count) const;
};

/// Says which robot drives in which site; `asked_to_stop` is asked at every sample.
struct Drive {
  agents::sim::SimBodyConfig body;
  std::function<bool()> asked_to_stop;
};

/// Teaches a robot that a hand leads along the line. None: stopped. refused: its end was not found to come back to
/// its beginning.
Result<std::optional<Course>> teach(const Drive& drive, const std::vector<agents::SitePoint>& line);

/// Compares where the robot is and believes to be on the path (Krajnik et al. 2018, fig. 1): metres ahead and left.
struct Deviation {
  double driven_m = 0.0;  ///< truly
  double along_m = 0.0;   ///< of the taught way, as it believes
  Pose2 site_from_robot;
  Pose2 path_from_robot;  ///< `path`: where it believes to be
};

struct Repeated {
  std::vector<Deviation> along;       ///< a row a sample
  std::vector<Deviation> after_loop;  ///< at the end of each
  std::string ended;                  ///< why it stands; empty: all loops were driven
  std::size_t looks = 0;              ///< views that were to tell where it is
  std::size_t fixes = 0;              ///< those that did
  double votes = 0.0;                 ///< of all these, for the place that was nearest
  std::vector<agents::LearnedPlace> learned_places;
};

/// Says where a robot is put down.
struct Start {
  Pose2 place_from_robot;
  std::size_t place = 0;
  bool is_told = true;  ///< at which place it stands; else it finds out
};

/// Puts the robot down beside the path and has it drive so many loops. None: stopped.
Result<std::optional<Repeated>> repeat(const Drive& drive, const Course& course, const Start& start,
                                       std::size_t loops, Parts parts);

}  // namespace weft::evaluate::bearing
