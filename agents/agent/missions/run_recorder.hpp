#pragma once
#include <string>
#include <vector>

#include "agents/agent/map_window.hpp"
#include "agents/agent/missions/taught_run.hpp"
#include "agents/agent/run_refining.hpp"
#include "agents/agent/spooler.hpp"
#include "agents/navigation/navigator.hpp"

namespace weft::agents {

/// Records a run that is taught: has the navigator keep places, and spools them with their contents.
class RunRecorder {
 public:
  struct Uses {
    RobotId robot;
    Navigator& navigator;
    MapWindow& map;
    Spooler& spooler;
    RunRefining& refining;
  };
  RunRecorder(const Uses& uses, TaughtRun run) : uses_(uses), run_(std::move(run)) {}

  const TaughtRun& run() const { return run_; }
  /// Begins to keep places, the first at the next view.
  void begin();
  /// Records places that were kept. Errors of the spool: not all is recorded, and teaching cannot go on.
  Result<void> keep(const std::vector<Kept>& kept, SteadyTime now);
  /// Has the spool write what it was given, so that the newest place is on disk.
  Result<void> flush(SteadyTime now) { return uses_.spooler.flush(now); }
  /// Ends a run that was taught to its end; what is refined is handed in later. Errors of the spool: the server will
  /// never have all of it.
  Result<void> seal(SteadyTime now);
  /// Ends a run before its end, with the last view. What has been taught until then stays, as far as the spool takes
  /// it.
  void break_off(SteadyTime now);

 private:
  void begin(ExperienceId experience, const std::string& name, const std::string& method);
  void leave();
  Result<void> close(const std::string& reason, SteadyTime now);

  Uses uses_;
  TaughtRun run_;
};

}  // namespace weft::agents
