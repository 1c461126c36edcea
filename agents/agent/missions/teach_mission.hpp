#pragma once
#include <optional>
#include <string>
#include <vector>

#include "agents/agent/condition.hpp"
#include "agents/agent/experience_ids.hpp"
#include "agents/agent/map_window.hpp"
#include "agents/agent/missions/place_requests.hpp"
#include "agents/agent/missions/run_recorder.hpp"
#include "agents/agent/missions/taught_run.hpp"
#include "agents/agent/missions/teach_preparation.hpp"
#include "agents/agent/missions/upload_confirmation.hpp"
#include "agents/agent/outbox.hpp"
#include "agents/agent/replies.hpp"
#include "agents/agent/run_refining.hpp"
#include "agents/agent/spooler.hpp"
#include "agents/navigation/navigator.hpp"

namespace weft::agents {

/// Carries out teaching, from the command to the sealed experience, its refinement, and until the server has all of
/// it.
class TeachMission {
 public:
  struct Uses {
    const AgentConfig& config;
    Navigator& navigator;
    MapWindow& map;
    Spooler& spooler;
    ExperienceIds& ids;
    Replies& replies;
    Outbox& outbox;
  };
  TeachMission(const Uses& uses, SteadyTime now)
      : uses_(uses), refining_({uses.navigator, uses.map, uses.spooler, uses.outbox}, now) {}

  /// Returns whether a new run is going to be taught. False: it is refused, or goes on with the run that is taught.
  bool start(const msg::AgentCommand& command, const CommandKey& key, const Condition& condition, bool has_route,
             SteadyTime now);
  void stop(const CommandKey& key, SteadyTime now);
  /// Lets a place be kept here, at the next view.
  void keep_place(const CommandKey& key, SteadyTime now);

  /// Holds an answer to be given only once the state no longer shows the end of the last part of the run: whoever
  /// waits for the end of the next part would take that for it.
  struct Answer {
    CommandKey key;
    msg::AgentReply reply;
  };
  std::optional<Answer> hand_answered(const Result<void>& answer);
  /// Returns whether the fix is what teaching waited for.
  bool on_fix();
  /// Takes what a sample has led to.
  void step(const std::vector<Kept>& kept, bool hand_done, SteadyTime now);
  /// Refines what was taught before, in the slack that a sample leaves.
  void refine(bool is_driving, SteadyTime now) { refining_.work(is_driving, now); }
  void tick(SteadyTime now);
  /// Answers the end of teaching when its time has come; see UploadConfirmation.
  void confirm(SteadyTime now) { confirmation_.tick(uses_.spooler, uses_.replies, now); }
  /// Takes note that the server has refused a batch of this experience.
  void refused(ExperienceId experience, const Spooler::Heard& heard, SteadyTime now);

  /// Ends teaching with what has been taught until now.
  void break_off(const std::string& reason, SteadyTime now);
  /// Ends teaching, if there is any, as the server will never have all of it: the robot is not to go on as if it were
  /// there.
  void abandon(const std::string& reason, SteadyTime now);

  /// Returns the run being taught; none: there is none.
  std::optional<ExperienceId> experience() const;
  bool is_active() const { return teaching_.has_value(); }
  /// Says what it waits for, for people, or "hand_done".
  std::string waits_for() const;
  /// Says how far it is with refining what was taught before, for people; empty: there is nothing to refine.
  std::string refines() const { return refining_.describe(); }
  /// Says why the last teaching ended by itself; empty: it did not.
  const std::string& failure() const { return failure_; }
  void forget_failure() { failure_.clear(); }

  std::optional<SteadyTime> next() const;
  void was_away(Duration away);

 private:
  struct Ending {
    CommandKey asked_by;
    SteadyTime deadline{};  ///< for a view of each camera: the last places
  };
  struct Teaching {
    RunRecorder recorder;
    CommandKey started_by;
    std::vector<SitePoint> along;
    std::optional<TeachPreparation> preparation;  ///< until it begins
    std::optional<CommandKey> next_part = {};     ///< waits for the hand to take up another line of the same run
    bool hand_done = false;
    std::optional<Ending> ending = {};

    bool is_on() const { return !preparation.has_value() && !ending.has_value(); }
  };
  Result<TaughtRun> run_for(const msg::AgentCommand& command, const Condition& condition, bool has_route);
  void go_on(const msg::AgentCommand& command, const CommandKey& key, const Condition& condition);
  void begin();
  void end(SteadyTime now);
  void keep(const std::vector<Kept>& kept, SteadyTime now);
  Result<void> try_keep(const std::vector<Kept>& kept, SteadyTime now);
  void refuse_start(const std::string& reason);
  TeachPreparation::Uses preparing() const { return {uses_.config.name, uses_.navigator, uses_.map, uses_.outbox}; }
  msg::AgentReply done() const;

  Uses uses_;
  RunRefining refining_;  ///< of what was taught until it is handed in
  std::optional<Teaching> teaching_;
  PlaceRequests requests_;
  UploadConfirmation confirmation_;
  std::string failure_;
};

}  // namespace weft::agents
