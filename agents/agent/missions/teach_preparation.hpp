#pragma once
#include <optional>
#include <string>
#include <vector>

#include "agents/agent/map_window.hpp"
#include "agents/agent/outbox.hpp"
#include "agents/navigation/navigator.hpp"
#include "core/result.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// Prepares a run between the command to teach and the first place: the map around the seed, the first fix there, and
/// the hand's word whether it can drive what is asked of it. Each of the three only where there is a seed or a line.
class TeachPreparation {
 public:
  struct Uses {
    const std::string& robot;  ///< its name
    Navigator& navigator;
    const MapWindow& map;
    Outbox& outbox;
  };
  TeachPreparation(const std::optional<PlaceId>& seed, std::vector<SitePoint> along, SteadyTime now);

  enum class Step { waits, begins };
  /// Goes on with the preparation. refused: teaching cannot begin, and why.
  Result<Step> tick(const Uses& uses, SteadyTime now);
  /// Returns whether the robot looks for itself around the seed.
  bool seeks() const { return phase_ == Phase::search; }
  /// Takes note of the fix for which it looked.
  Step on_fix(const Uses& uses) { return start_hand(uses); }
  /// Returns whether the hand's answer is awaited.
  bool awaits_hand() const { return phase_ == Phase::hand; }

  /// Says what it waits for, for people; empty: for the hand.
  std::string waits_for() const;
  std::optional<SteadyTime> next() const;
  void was_away(Duration away) { deadline_ += away; }

 private:
  enum class Phase { map, search, hand };
  Result<Step> await_map(const Uses& uses, SteadyTime now);
  Step start_hand(const Uses& uses);

  Phase phase_ = Phase::map;
  std::optional<PlaceId> seed_;
  std::vector<SitePoint> along_;
  SteadyTime deadline_;
};

}  // namespace weft::agents
