#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "agents/methods/method.hpp"
#include "core/ids.hpp"

namespace weft::agents {

/// Whether another robot that comes by finds a place again.
struct Trial {
  bool found = false;
  std::string_view refused;  ///< why not; static text
  double sigma_m = 0.0;      ///< of where it is found
};
using Trials = std::array<Trial, prospects>;  ///< by Prospect

struct TaughtPlace {
  PlaceId id;
  double at_m = 0.0;             ///< driven from where teaching began
  std::optional<Trials> trials;  ///< none: not tried, or not yet
};

/// A place was due, and what was seen was not worth one.
struct Missed {
  double at_m = 0.0;
  std::string_view reason;  ///< static text
};

/// What a robot has been taught since teaching began, with what teaching found out about it.
struct TaughtWay {
  ExperienceId experience;
  double driven_m = 0.0;
  std::vector<TaughtPlace> places;
  std::vector<Missed> missed;
};

/// What an operator wants to know of a stretch before he leaves it.
struct TaughtStretch {
  double from_m = 0.0;
  double to_m = 0.0;
  std::uint32_t places = 0;
  PlaceId first;                          ///< of the places; without any the last one before
  std::array<double, prospects> found{};  ///< share of the places tried
  double sigma_m = 0.0;                   ///< mean, of those that are found as they are
  std::string reason;  ///< which prospect is the worst, and what it is refused for most often; empty: none is
};

/// A row a metre; a way longer than `most` metres has longer ones. Where no place was kept because of what was seen,
/// nothing is found, and the row says why. A metre of which nothing has been tried counts to the row before it, and
/// at the end to none: rows end where trying has come to. Empty: nothing has been tried yet.
std::vector<TaughtStretch> stretches_of(const TaughtWay& way, std::size_t most);

/// "as is", "half light", "worn".
std::string_view name_of(Prospect prospect);

}  // namespace weft::agents
