#pragma once
#include <optional>
#include <string>

#include "agents/agent/missions/taught_run.hpp"
#include "agents/agent/replies.hpp"
#include "agents/agent/spooler.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// Answers the end of teaching when the server has acknowledged all of the run, so that the operator can go on with
/// it; after 15 s it answers that this is not yet so. The 15 s of a run that is refined first begin when it is
/// refined, and end 30 s after the end of teaching at the latest.
class UploadConfirmation {
 public:
  void await(TaughtRun run, const CommandKey& asked_by, SteadyTime now);
  /// Forgets the run without an answer.
  void drop() { awaited_.reset(); }
  void tick(const Spooler& spooler, Replies& replies, SteadyTime now);
  /// Takes note that the server has refused some of the experience, which may be the one that is waited for.
  void refused(ExperienceId experience, const std::string& reason, Replies& replies);

  bool is_awaiting() const { return awaited_.has_value(); }
  std::optional<SteadyTime> next() const;
  void was_away(Duration away);

 private:
  struct Awaited {
    TaughtRun run;
    CommandKey asked_by;
    SteadyTime deadline{};
    SteadyTime at_latest{};  ///< however long it is refined
  };
  std::optional<Awaited> awaited_;
};

}  // namespace weft::agents
