#pragma once
#include <deque>
#include <memory>
#include <optional>
#include <set>
#include <string>

#include "agents/agent/budget.hpp"
#include "agents/agent/map_window.hpp"
#include "agents/agent/outbox.hpp"
#include "agents/agent/spooler.hpp"
#include "agents/navigation/navigator.hpp"
#include "agents/navigation/run_refiner.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// Refines what was taught by methods that refine, one run after the other, before any of it is handed in: until then
/// the spooler holds it back. It works beside the samples of the body, and by itself where none come; not while
/// another run is being taught, which needs every sample.
class RunRefining {
 public:
  struct Uses {
    const Navigator& navigator;
    MapWindow& map;
    Spooler& spooler;
    Outbox& outbox;
  };
  RunRefining(const Uses& uses, SteadyTime now);

  /// Takes note that teaching of an experience begins, which the spooler knows: it is held back if its method
  /// refines.
  void begin(ExperienceId experience, const std::string& method);
  /// Takes note of a place that is in the spooler's hands.
  void add(const Kept& kept);
  /// Takes note that teaching of the experience is over and that the spooler has sealed it, or has given it up.
  void end(ExperienceId experience);

  /// Works in the slack that a sample leaves, less while the robot drives.
  void work(bool is_driving, SteadyTime now);
  /// Works if no sample has come for long.
  void tick(SteadyTime now);
  std::optional<SteadyTime> next() const;

  /// Says how far it is, for people; empty: nothing is to be refined.
  std::string describe() const;

 private:
  struct Draft {
    ExperienceId experience;
    std::unique_ptr<RunRefiner> refiner;
  };
  bool may_work() const;
  void piece();
  void hand_in(const Draft& draft);

  Uses uses_;
  std::set<ExperienceId> taught_;  ///< by whatever method
  std::deque<Draft> drafts_;       ///< oldest first
  Budget budget_;                  ///< of time, in microseconds
  Budget driven_budget_;           ///< the same, while the robot drives
  SteadyTime by_itself_at_;        ///< unless a sample comes before
};

}  // namespace weft::agents
