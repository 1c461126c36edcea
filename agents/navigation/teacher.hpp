#pragma once
#include <optional>
#include <vector>

#include "agents/navigation/config.hpp"
#include "agents/navigation/navigator.hpp"

namespace weft::agents {

/// Decides when a place is kept and joins it to the one before (Gadd & Newman III-B: by xi_t and xi_R). A value.
class Teacher {
 public:
  /// `both_ways`: what is taught is driven in either direction.
  Teacher(const TeachConfig& config, const TeachStart& start, std::string_view method, std::uint32_t content_format,
          bool both_ways = false)
      : config_(config), start_(start), method_(method), content_format_(content_format), both_ways_(both_ways) {}

  void advance(const Step& step);
  /// Returns whether a place is due: at the first view, after enough travel or turning since the last place, or if
  /// asked for.
  bool due() const;
  void ask() { asked_ = true; }
  /// Returns whether the robot is far enough from the last place to end the run with one of its own.
  bool worth_an_end() const;
  /// Returns whether there was any step since the last place.
  bool has_moved() const { return since_.has_value(); }

  /// Keeps a place here: its odometry edge is blind if any step since the last place was.
  Kept keep(Bytes content, std::uint64_t frame, SensorTime time);

  /// Returns where the robot is on its own chain: the last place kept and the way since. None before the first.
  std::optional<Estimate> estimate() const;
  /// Returns the metres driven since teaching began.
  double driven_m() const { return driven_m_.empty() ? 0.0 : driven_m_.back() + since_m_; }
  /// Returns the metres driven from own place `index` to the last one.
  double driven_since_m(std::uint32_t index) const { return driven_m_.back() - driven_m_[index]; }
  const TeachStart& start() const { return start_; }

 private:
  Relation last_from_robot() const;
  Drivable drivable(const Relation& last_from_kept) const;

  TeachConfig config_;
  TeachStart start_;
  std::string method_;
  std::uint32_t content_format_ = 1;
  bool both_ways_ = false;
  std::vector<double> driven_m_;  // up to each place kept
  std::optional<PlaceId> last_;
  std::optional<Step> since_;  // the last place; none: has not moved since
  double since_m_ = 0.0;
  bool asked_ = false;
};

}  // namespace weft::agents
