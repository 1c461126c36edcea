#pragma once
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "agents/methods/method.hpp"
#include "agents/navigation/config.hpp"
#include "core/network/window.hpp"

namespace weft::agents {

/// Keeps the order in which places are tried by a robot that does not know where it is. A value, pure.
class RelocalisationQueue {
 public:
  /// Begins a search around a seed (Gadd & Newman III-C, B), or, without one, around where the robot was last
  /// believed, then at what is proposed, then in the whole window.
  void start(const std::optional<PlaceId>& seed);
  void end() { active_ = false; }
  /// Leaves the places of a run out, too, until the next start.
  void leave_out(const ExperienceId& run) { left_out_.insert(run); }
  const std::set<ExperienceId>& left_out() const { return left_out_; }
  bool leaves_out(const PlaceId& place) const { return left_out_.contains(place.experience); }
  bool active() const { return active_; }
  bool seeded() const { return seed_.has_value(); }

  /// Makes the order when there is none. Refused: "window_empty", "seed_not_in_window"; "seek_pause" for some samples
  /// after a pass over all places.
  OrRefusal<void> prepare(const NavigationConfig& config, const Window& window, const std::optional<Estimate>& last);
  /// Returns the places that are still to be tried in this pass, the next one last.
  std::vector<PlaceId>& order() { return order_; }
  std::optional<PlaceId> next();
  /// Returns whether places around where the robot was last believed are left to try.
  bool looks_near() const { return near_left_ > 0; }
  /// Returns the places that were proposed and are still to be tried, the likeliest first.
  std::vector<PlaceId>& proposed() { return proposed_; }
  /// Returns whether signatures have been used to order this pass.
  bool ordered() const { return ordered_; }
  void set_ordered() { ordered_ = true; }

 private:
  bool active_ = false;
  std::optional<PlaceId> seed_;
  std::set<ExperienceId> left_out_;
  std::vector<PlaceId> order_;  // the next one last
  std::size_t near_left_ = 0;   // of order_, at its end
  std::vector<PlaceId> proposed_;
  bool ordered_ = false;
  std::uint32_t pause_ = 0;
};

/// Returns whether the window holds places of other runs than this one.
bool has_others(const Window& window, const ExperienceId& run);

}  // namespace weft::agents
