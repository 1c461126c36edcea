#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clients/evaluate/bearing/course.hpp"
#include "clients/evaluate/bearing/relocalise/aisles.hpp"

namespace weft::evaluate::bearing {

/// Holds what robots were taught of a hall, with its truth: for judging, nobody else sees it.
struct TaughtAisles {
  TaughtMap map;
  std::map<PlaceId, Pose2> site_from_place;
};

/// Teaches one robot a run for each aisle but the one that is left out. None: stopped.
Result<std::optional<TaughtAisles>> teach(const Drive& drive, const Aisles& aisles);

/// Records one robot that was put down and led.
struct Led {
  Pose2 site_from_robot;          ///< where it was put down
  std::optional<double> found_m;  ///< led so far until it believed to know where it is; none: it never did
  // Believed against the truth, then
  double along_m = 0.0;     ///< further along the path than it is
  double aside_m = 0.0;     ///< of the place that it believes to be at, to the left
  double turned_rad = 0.0;  ///< further to the left than it is
  double sigma_m = 0.0;     ///< along the path, as it says itself
  std::string refused;      ///< most often, when it never did
};

/// Returns whether a robot that found itself is about where it believes to be.
bool is_right(const Led& led);
inline constexpr double kRightAlongM = 0.3;
inline constexpr double kRightAsideM = 1.5;  ///< from so far it comes back to the way
inline constexpr double kRightRad = 0.1;

/// Leads one body that is put down again and again.
class Leading {
 public:
  static Result<Leading> make(const Drive& drive);
  /// Leads it with a new navigator: all settings are the defaults, and it knows nothing but the map. None: stopped.
  Result<std::optional<Led>> lead(const PutDown& put_down, const TaughtAisles& taught);

 private:
  Leading(std::unique_ptr<agents::sim::SimulatedBody> body, std::function<bool()> asked_to_stop)
      : body_(std::move(body)), asked_to_stop_(std::move(asked_to_stop)) {}

  std::unique_ptr<agents::sim::SimulatedBody> body_;
  std::function<bool()> asked_to_stop_;
};

}  // namespace weft::evaluate::bearing
