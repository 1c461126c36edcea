#pragma once
#include <deque>
#include <map>
#include <optional>
#include <string>

#include "agents/perception/mount.hpp"
#include "core/ids.hpp"

namespace weft::agents {

/// Notices a robot that stands higher or lower than its places say: load, tyres, a mount that has moved. One camera
/// cannot see its height, but stored places show it against the camera that they were taught with. Two calibrations
/// may differ by millimetres, which hide a load or look like one; so a robot is also compared with itself, as it
/// stood before on the places of the same experience. A value.
class LiftWatch {
 public:
  /// Of one fix: on a place of which experience, and its Related::lift_m.
  void add(const ExperienceId& experience, double lift_m);
  /// Against its places: median of the newest fixes, metres, positive: higher; none before there are enough of them.
  std::optional<double> lift_m() const { return median_of(newest_); }
  /// Against itself before, on the same experiences; likewise.
  std::optional<double> change_m() const { return median_of(changes_); }
  /// For people: what was noticed and what to look at; empty when there is nothing. Against places it begins at 7 mm
  /// (1 cm of sinking is to be noticed, and two calibrations may differ by 3 mm) and ends below 5 mm; against itself
  /// it begins at 5 mm, where no calibration plays a part, and ends below 3 mm.
  const std::string& notice() const { return notice_; }

 private:
  static std::optional<double> median_of(const std::deque<double>& newest);
  void note_change(const ExperienceId& experience, double lift_m);
  void look();

  std::deque<double> newest_;
  std::deque<double> changes_;
  std::map<ExperienceId, std::deque<double>> before_;  // its first fixes on each
  bool off_places_ = false;
  bool has_changed_ = false;
  std::string notice_;
};

/// A line for the log: tilt, and height by wheels or stored places; without either that it is not observable.
std::string words_of(const MountReport& report, const std::optional<double>& lift_m);

}  // namespace weft::agents
