#pragma once
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "agents/navigation/navigator.hpp"
#include "core/diagnostic.hpp"
#include "core/ids.hpp"

namespace weft::agents {

/// Watches one diagnostic of fixes over a drive, by medians of the newest ones. Places were taught by other robots,
/// whose calibrations hide a small change or look like one; so a robot is also compared with itself, as it was before
/// on the places of the same experience. A value.
class DiagnosticWatch {
 public:
  explicit DiagnosticWatch(const WatchedDiagnostic& what) : what_(what) {}

  const WatchedDiagnostic& what() const { return what_; }
  /// Takes the diagnostic of one fix on a place of that experience.
  void add(const ExperienceId& experience, double value);
  /// Returns the median of the newest fixes; none before there are enough of them.
  std::optional<double> value() const { return median_of(newest_); }
  /// Returns the median of the newest changes against itself before, on the same experiences; likewise.
  std::optional<double> change() const { return median_of(changes_); }
  /// Returns what was noticed, for people; empty: nothing.
  const std::string& notice() const { return notice_; }

 private:
  static std::optional<double> median_of(const std::deque<double>& newest);
  void note_change(const ExperienceId& experience, double value);
  void look();

  WatchedDiagnostic what_;
  std::deque<double> newest_;
  std::deque<double> changes_;
  std::map<ExperienceId, std::deque<double>> before_;  // its first fixes on each
  bool off_places_ = false;
  bool has_changed_ = false;
  std::string notice_;
};

/// Watches all diagnostics that a robot's methods name.
class DiagnosticWatches {
 public:
  explicit DiagnosticWatches(const std::vector<WatchedDiagnostic>& all);

  /// Takes a fix; returns the note that its diagnostics lead to: a notice that begins, or the end of one. Empty:
  /// none.
  std::string add(const Fix& fix);
  /// Returns the first notice that stands; empty: none does.
  std::string notice() const;
  /// Returns `measured` and the medians of those that are watched, with their bounds.
  std::vector<Diagnostic> all(std::vector<Diagnostic> measured) const;

 private:
  std::vector<DiagnosticWatch> watches_;
};

/// Returns a line for the log: "mount_pitch_rad +0.0087 (one sigma 0.0006), height_offset_m -0.0101"; empty: of none.
std::string words_of(const std::vector<Diagnostic>& diagnostics);

}  // namespace weft::agents
