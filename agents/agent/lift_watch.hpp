#pragma once
#include <deque>
#include <optional>
#include <string>

#include "agents/perception/mount.hpp"

namespace weft::agents {

/// Notices a robot that stands higher or lower than when its places were taught: load, tyres, a mount that has moved.
/// One camera cannot see its height, but stored places show it, as long as they were taught by a camera whose height
/// was known.
class LiftWatch {
 public:
  /// Of one fix: Related::lift_m.
  void add(double lift_m);
  /// Median of the newest fixes, metres, positive: higher; none before there are enough of them.
  std::optional<double> lift_m() const;
  /// For people: what was noticed and what to look at; empty when there is nothing. It begins at 7 mm (1 cm of
  /// sinking is to be noticed, and two calibrations may differ by 3 mm) and ends below 5 mm.
  const std::string& notice() const { return notice_; }

 private:
  std::deque<double> newest_;
  std::string notice_;
};

/// A line for the log: tilt, and height by wheels or stored places; without either that it is not observable.
std::string words_of(const MountReport& report, const std::optional<double>& lift_m);

}  // namespace weft::agents
