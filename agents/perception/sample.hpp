#pragma once
#include <algorithm>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "agents/perception/motion.hpp"
#include "agents/perception/view.hpp"
#include "core/safety.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// Tells what a body's battery holds.
struct Charge {
  double share = 1.0;  ///< of full
  bool is_charging = false;
  std::optional<double> minutes{};  ///< until it is empty, or full when it charges; none: not known
  bool operator==(const Charge&) const = default;
};

/// Holds one tick of a body: what has moved since the last one, and a view of each sensor that fired.
struct Sample {
  std::uint64_t frame = 0;
  SensorTime time{};
  std::vector<View> views;         ///< none: no sensor was due, or its frame was dropped
  Motion motion;                   ///< since the last sample
  bool hand = false;               ///< someone else drives (teaching): `motion.command` is his
  bool hand_done = false;          ///< the hand has reached the end of what it was asked to drive
  Safety safety = Safety::ok;      ///< as the base's own rated functions say
  std::optional<Charge> charge{};  ///< none: the body does not know, or has no battery

  /// Returns the view of that sensor; null: it has none. "" is whichever sensor fired first, for bodies that have
  /// one.
  const View* of(std::string_view sensor) const {
    const auto found = std::find_if(views.begin(), views.end(),
                                    [sensor](const View& view) { return sensor.empty() || view.sensor == sensor; });
    return found == views.end() ? nullptr : &*found;
  }
};

}  // namespace weft::agents
