#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "core/protocol/messages.hpp"
#include "server/base/context.hpp"
#include "server/base/request_ledger.hpp"
#include "server/dispatcher/dispatcher.hpp"
#include "server/editor/editor.hpp"
#include "server/fleet/fleet.hpp"
#include "server/jobs/jobs.hpp"
#include "server/requests/awaited_labels.hpp"
#include "server/requests/commands.hpp"
#include "server/requests/registering.hpp"
#include "server/site/site_frames.hpp"

namespace weft::server {

/// Serves operators: what the server can do itself is done at once, the rest is taken to the robot, and the operator
/// is answered when the robot has answered.
class OperatorRequests {
 public:
  OperatorRequests(Context& context, Fleet& fleet, Traffic& traffic, Dispatcher& dispatcher,
                   const SiteFrames& site_frames,
                   const std::map<std::string, storage::PutAwaitedLabel>& awaited_labels, SteadyTime now)
      : context_(context),
        fleet_(fleet),
        dispatcher_(dispatcher),
        site_frames_(site_frames),
        editor_(context, traffic, dispatcher),
        jobs_(context, editor_),
        registering_(context, editor_),
        commands_(context),
        awaited_labels_(awaited_labels, now) {
    // A client that repeats its request after a restart waits on.
    for (const auto& [name, label] : awaited_labels) std::ignore = ledger_.see(key_of(label));
  }

  /// Does the request once; `who` is the client's name.
  void on_request(const msg::OperatorRequest& request, const std::string& who, Now now);
  void on_reply(const msg::AgentReply& reply, Now now);
  /// Tells a robot again what it should know: a paused goal's robot stands, that of another goal drives.
  void on_state(const Robot& robot, Now now);
  void on_silence(const RobotId& robot, SteadyTime now);
  /// Stops a robot whose id two live agents share.
  void on_twins(const RobotId& robot, Now now);
  /// Sets the labels that wait for what has joined the map.
  void joined(Now now) { settle_labels(now); }
  /// Notes that the batch will never join, nor what its robot would have handed in behind it.
  void refused(const Batch& batch, const Error& why, Now now);

  void tick(Now now);
  std::optional<SteadyTime> next() const;
  const AwaitedLabels& awaited_labels() const { return awaited_labels_; }

 private:
  using Key = RequestLedger::Key;
  /// Holds a request that waits for one or more robots.
  struct Waiting {
    std::set<std::uint64_t> commands;
    std::string message;  ///< so far
    bool failed = false;
  };

  /// Holds robots that were told together to stop or to go on, and what each has said.
  struct GroupCommand {
    struct Robot {
      RobotId id;
      std::string goal;                      ///< what became of its goal
      std::optional<std::uint64_t> command;  ///< not answered yet
      bool has_confirmed = false;
      std::string refusal;
    };
    bool stops = true;
    std::vector<Robot> robots;
    SteadyTime answer_by;
  };

  void answer(const Key& key, msg::OperatorReply reply);
  void answer(const Key& key, msg::Outcome outcome, const std::string& message);
  void tell(const Key& key, msg::OperatorReply reply);
  void command_one(const Key& key, const msg::OperatorRequest& request, const std::string& who, Now now);

  // These stop robots and let them go on (stopping.cpp).
  void stop_or_resume(const Key& key, const msg::OperatorRequest& request, const std::string& who, Now now);
  GroupCommand::Robot command_in_group(const Key& key, const Robot& robot, const msg::OperatorRequest& request,
                                       const std::string& who, Now now);
  void group_answered(const Key& key, std::uint64_t command, const msg::AgentReply& reply, SteadyTime now);
  void group_fell_silent(const Key& key, std::uint64_t command, SteadyTime now);
  void answer_overdue(SteadyTime now);
  void answer_group(const Key& key, SteadyTime now);
  std::string line_of(const GroupCommand& group, const GroupCommand::Robot& robot, SteadyTime now) const;
  std::string reach_of(const RobotId& robot) const;

  // These set labels, at once or when their place comes (labels.cpp).
  void label(const Key& key, const msg::OperatorRequest& request, const std::string& who, Now now);
  void label_here(const Key& key, const msg::OperatorRequest& request, const std::string& who, Now now);
  std::string label_moves(const std::string& label, const PlaceId& place) const;
  Result<void> put_label(const std::string& label, const PlaceId& place, const std::string& who, Now now);
  void remove_label(const Key& key, const msg::OperatorRequest& request, const std::string& who, Now now);
  void rename_label(const Key& key, const msg::OperatorRequest& request, const std::string& who, Now now);
  void withdraw_label(const std::string& label, const std::string& why, const std::string& who,
                      msg::OperatorReply& reply, Now now);
  void label_kept_place(AwaitedLabels::Label label, Now now);
  void settle_labels(Now now);
  void settle_label(const AwaitedLabels::Awaited& awaited, Now now);
  Result<void> drop_label(const std::string& label, const std::string& why, const std::string& who, Now now);

  void send_to_plan(const Key& key, const msg::OperatorRequest& request, const std::string& who, Now now);
  void clear(const Key& key, const msg::OperatorRequest& request, const std::string& who, Now now);
  void hold_or_free(const Key& key, const msg::OperatorRequest& request, const std::string& who, Now now);
  void forget_or_rename(const Key& key, const msg::OperatorRequest& request, const std::string& who, Now now);
  Result<msg::AgentCommand> command_for(const msg::OperatorRequest& request, const Robot& robot) const;
  Result<const Robot*> reachable(const std::string& name) const;
  void send_for(const Key& key, msg::AgentCommand command, SteadyTime now);
  bool is_said_before_answer(const msg::RobotState& state) const;
  void robot_answered(const msg::AgentCommand& command, const msg::AgentReply& reply, Now now);
  std::string what_the_end_lacks(const ExperienceId& run) const;

  Context& context_;
  Fleet& fleet_;
  Dispatcher& dispatcher_;
  const SiteFrames& site_frames_;
  Editor editor_;
  Jobs jobs_;
  Registering registering_;
  Commands commands_;
  RequestLedger ledger_;
  std::map<Key, Waiting> waiting_;
  std::map<Key, GroupCommand> group_commands_;
  std::map<std::uint64_t, Key> asked_for_;         ///< by command
  std::map<Key, std::string> asked_by_;            ///< names, of those that wait for a kept place
  std::map<RobotId, msg::Header> answered_;        ///< of the last answer to a command
  std::map<RobotId, std::string> unstored_stops_;  ///< who asked; the goal is still to be paused
  AwaitedLabels awaited_labels_;
};

}  // namespace weft::server
