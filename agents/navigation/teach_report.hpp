#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/diagnostic.hpp"
#include "core/ids.hpp"

namespace weft::agents {

/// Says whether another robot that comes by finds a place again.
struct Trial {
  bool found = false;
  std::string_view refused;  ///< why not; static text
  double sigma_m = 0.0;      ///< of where it is found
};
using Trials = std::vector<Trial>;  ///< by condition, as TeachReport::conditions has them

struct TaughtPlace {
  PlaceId id;
  double at_m = 0.0;             ///< driven from where teaching began
  std::optional<Trials> trials;  ///< none: not tried, or not yet
};

/// Notes where a place was due and what was seen was not worth one.
struct Missed {
  double at_m = 0.0;
  std::string_view reason;  ///< static text
};

/// Notes a stretch of which the robot saw nothing while it drove: how far and where to is what it was told, not what
/// it saw.
struct BlindStretch {
  double from_m = 0.0;
  double to_m = 0.0;
  std::string_view reason;  ///< static text
};

/// Reports what a robot has been taught since teaching began, and whether other robots will find it again.
struct TeachReport {
  ExperienceId experience;
  std::vector<std::string_view> conditions;  ///< under which places are tried, the mildest first; static texts
  double driven_m = 0.0;
  std::vector<TaughtPlace> places;
  std::vector<Missed> missed;
  std::vector<BlindStretch> blind;
};

/// Names the share of a stretch's metres in which the robot saw how it moved.
inline constexpr std::string_view kSeenShare = "seen";

/// Describes a stretch as an operator wants to know it before he leaves it.
struct TaughtStretch {
  double from_m = 0.0;
  double to_m = 0.0;
  std::uint32_t places = 0;
  PlaceId first;                  ///< of the places; without any the last one before
  std::vector<Diagnostic> found;  ///< by condition: the share of the places tried that are found; last kSeenShare
  double sigma_m = 0.0;           ///< mean, of those that are found as they are
  std::string reason;  ///< which of these is the worst, and what is refused most often then; empty: none is
};

/// Sets the least share of a stretch's places that must be found, and of its metres that must have been seen; with
/// fewer a robot will not find itself there.
inline constexpr double kFoundEnough = 0.5;

/// Returns a row a metre; a way longer than `most` metres has longer ones. Where no place was kept because of what
/// was seen, nothing is found, and the row says why. A metre of which nothing has been tried counts to the row before
/// it, and at the end to none: rows end where trying has come to. Empty: nothing has been tried yet.
std::vector<TaughtStretch> stretches_of(const TeachReport& report, std::size_t most);

}  // namespace weft::agents
