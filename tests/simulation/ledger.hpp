#pragma once
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "agents/agent/agent.hpp"
#include "core/protocol/messages.hpp"
#include "server/service.hpp"
#include "storage/memory/memory_store.hpp"
#include "storage/spool/memory_spool.hpp"
#include "tests/simulation/contacts.hpp"
#include "tests/simulation/marks_body.hpp"
#include "tests/simulation/progress.hpp"
#include "tests/simulation/ruled_floor.hpp"

namespace weft::simulation {

/// Names a broken invariant, and what was seen.
struct Violation {
  std::string invariant;
  std::string what;
};

/// Holds all that the invariants must remember about one run. It is told what crosses the border of each process and
/// looks at the truth; nothing it knows flows back.
class Ledger {
 public:
  struct Robot {
    const MarksBody* body = nullptr;
    const agents::Agent* agent = nullptr;  ///< null while it is down
    std::string name;
    msg::RobotState state;        ///< last one said
    WindowDefinition wants;       ///< last one asked for
    std::optional<Route> had;     ///< its route when last looked at
    std::uint32_t passed = 0;     ///< of `had`: freed in a version before it, which may come by the same place twice
    msg::RouteProgress progress;  ///< last one said
    double footprint_m = 0.0;     ///< as it describes itself
    bool refines = false;         ///< what it was taught, before it hands that in
    bool led = false;             ///< when it last moved
    std::optional<Eigen::Vector2d> lost_at;  ///< where it came to rest when it did not know where it was any more
    bool unheard = false;                    ///< since a hand has put it down
    bool is_hung = false;                    ///< its process stands still
    bool is_cut_off = false;                 ///< nobody hears it
    std::map<std::uint64_t, msg::AgentCommand::Kind> commands;  ///< that it has heard, by number
    bool is_stopped = false;                                    ///< an operator has stopped it, and not resumed it
    bool had_emergency = false;              ///< it knows of an emergency stop after which nobody has resumed it
    std::optional<SteadyTime> struck;        ///< its disk refused something last then
    bool ended_while_struck = false;         ///< its agent did
    std::vector<storage::BatchKey> spooled;  ///< on its disk, with places
    SteadyTime heard{};                      ///< by the server, last
    SteadyTime drove{};                      ///< by itself, last
    SteadyTime stands_since{};               ///< it has not moved, was told nothing new, and was at work
  };
  /// Keeps what breaks of the invariants `told` apart: it is no violation.
  Ledger(double footprint_m, std::set<std::string> told) : footprint_m_(footprint_m), told_only_(std::move(told)) {}

  std::map<RobotId, Robot> robots;

  /// Sets the time of everything that follows.
  void set_now(SteadyTime now) { now_ = now; }
  /// Notes where a place of a map truly lies that was in the store before.
  void stored(const PlaceId& place, const Pose2& site_from_place) { truth_.emplace(place, site_from_place); }
  void agent_sent(const RobotId& robot, const msg::Message& message);
  /// Checks an acknowledgement, as it arrives, against the disk.
  void agent_heard(const RobotId& robot, const msg::Message& message, const storage::MemoryDisk& disk);
  /// Notes what a robot may drive now; to be called after it has taken a message in.
  void agent_took(const RobotId& robot);
  void server_sent(const msg::Message& message, const server::Service& service);
  void server_heard(const msg::Message& message);
  /// Takes in the first that a server says of itself after it has stood still, and has taken in what came meanwhile.
  void server_woke(const std::vector<msg::Message>& said);
  /// Notes that a server has come up, or goes on after it has stood still.
  void server_up(SteadyTime now) { served_since_ = now; }
  void client_heard(const msg::Message& message);
  void agent_started(const RobotId& robot, const agents::Agent& agent, const storage::SpoolDisk& disk);
  void agent_ended(const RobotId& robot);
  /// Notes that the robot's disk has just refused to take something.
  void spool_struck(const RobotId& robot);
  /// Checks that nothing has gone from the robot's disk that the server does not have on its own.
  void look_at_spool(const RobotId& robot, const storage::SpoolDisk& spool, const storage::MemoryDisk& disk);
  /// Checks that who is not heard does not count as heard, by what a client is told of all robots.
  void look_at_silence(const std::vector<msg::RobotRow>& rows);
  void agent_stepped(const RobotId& robot, const agents::Sample& sample, const agents::AgentOutput& output);
  /// Compares the body, which has taken a step, with all others by the truth.
  void body_moved(const RobotId& robot);
  /// Looks at goals every few seconds, also while no server is up: they do not count then.
  void look_at_goals(const storage::MemoryDisk& disk, bool is_served);
  /// Looks at what a client is told of all robots.
  void look_at_waits(const std::vector<msg::RobotRow>& rows, const storage::MemoryDisk& disk);
  /// Checks what must hold at any moment at which a server is up.
  void look(const server::Service& service, const storage::MemoryDisk& disk);
  /// Checks what must hold once faults are over, everyone is up, people have helped where robots waited for one
  /// another, and nothing has been asked for a while.
  void look_when_quiet(const server::Service& service, const storage::MemoryDisk& disk);

  /// Notes that people have asked for an edit of the map, or have undone it: meanwhile not all that is stored is
  /// served.
  void map_edited(bool is_edited) { is_edited_ = is_edited; }

  /// Notes that people have laid down a rule that closes something, or have removed it.
  void ruled(bool is_ruled) { is_ruled_ = is_ruled; }

  /// Returns how often a robot was found to stand for long, and what was told of it was looked at.
  std::uint64_t stood() const { return stood_; }
  /// Returns how many batches were handed in refined.
  std::uint64_t refined() const { return refined_; }
  const std::vector<Violation>& violations() const { return violations_; }
  const std::vector<Violation>& told() const { return told_; }
  std::uint64_t acknowledged() const { return acknowledged_count_; }
  std::map<std::string, std::uint64_t> goals_by_state() const;

 private:
  struct Stretch {
    Route route;
    std::uint32_t from = 0;
    bool known = false;  ///< its robot has said that it has it, or has been told that it is over
  };
  void broken(const std::string& invariant, const std::string& what);
  std::optional<Pose2> truth_of(const PlaceId& place) const;
  bool are_close(const PlaceId& a, const PlaceId& b) const;
  std::optional<Pose2> said_to_stand(const RobotId& robot) const;
  bool moves_away(const RobotId& robot, const PlaceId& place, const Route& theirs, std::uint32_t from) const;
  std::uint32_t passed_by(const Robot& robot, const Route& route) const;
  std::uint32_t ahead_from(const Robot& robot, const Route& route, std::uint32_t passed) const;
  void check_release(const Route& route, const Snapshot& snapshot);
  void check_standing(const RobotId& id, const PlaceId& place, const Snapshot& snapshot);
  void note_put_down(const RobotId& robot);
  void check_lost(Robot& by, const agents::AgentOutput& output);
  void check_released_point(const Robot& robot);
  void check_belief(const Robot& robot);
  void check_acknowledged(const server::Service& service, const storage::MemoryDisk& disk);
  void check_revisions(const server::Service& service, const storage::MemoryDisk& disk);
  void check_stitches(const Snapshot& snapshot);
  bool is_at_work(const Robot& robot) const;
  bool counts(const Goal& goal, const std::set<RobotId>& busy) const;
  void note_stops(Robot& by, const msg::Message& sent);
  void check_draft(const Robot& by, const msg::ExperienceBatch& sent);
  void check_spools_when_quiet(const Snapshot& snapshot, const storage::MemoryDisk& disk);
  void note_heard(const msg::Message& message);
  void check_stops(Robot& by, const agents::Sample& sample, const agents::Twist& command);
  void check_limits(const Robot& by);
  void check_driver(const RobotId& id, const Robot& robot);
  void check_rules(const Route& route, std::uint32_t first, std::uint32_t next, const Snapshot& snapshot);
  const Route* stands_with(const RobotId& id, const Robot& robot, const storage::MemoryDisk& disk) const;
  bool is_near(const RobotId& robot, const PlaceId& place, double within_m) const;
  bool is_ahead(const RobotId& robot, const Route& route, double within_m) const;
  bool is_to_pass(const RobotId& robot, const PlaceId& place, const Route& way, double within_m,
                  const storage::MemoryDisk& disk) const;
  std::string wrong_wait(const RobotId& id, const msg::RobotWait& wait, const Route& route,
                         const storage::MemoryDisk& disk) const;
  void check_goals(const server::Service& service);
  bool waits_for_the_lost(const Goal& goal) const;

  double footprint_m_;
  std::set<std::string> told_only_;  ///< invariants
  SteadyTime now_{};
  std::map<std::string, int> said_;
  std::vector<Violation> violations_;
  std::vector<Violation> told_;
  std::map<PlaceId, Pose2> truth_;  ///< of every place that was ever sent
  std::map<ExperienceId, std::map<std::uint64_t, Batch>> sent_;
  /// Describes a run of a robot that refines, as it was handed in so far.
  struct Run {
    std::uint64_t taught_in = 0;  ///< incarnation of the agent; 0: unknown
    bool has_refined = false;     ///< relations
    bool has_drafts = false;
    bool was_refused = false;  ///< something by its robot's disk: it may be handed in as it is
  };
  std::map<ExperienceId, Run> runs_;
  std::uint64_t refined_ = 0;  ///< batches
  std::map<ExperienceId, std::uint64_t> acknowledged_;
  std::set<ExperienceId> refused_;  ///< by the server
  SteadyTime served_since_{};
  std::uint64_t acknowledged_count_ = 0;
  bool is_edited_ = false;
  bool is_ruled_ = false;
  Progress progress_;
  std::map<GoalId, RobotId> drivers_;  ///< who drove last for a goal
  std::map<RobotId, int> wrong_;       ///< looks in a row at which what was told of its wait was wrong
  std::uint64_t stood_ = 0;
  std::map<RobotId, Stretch> held_;           ///< released to a robot, not yet freed
  std::map<RobotId, msg::RobotState> known_;  ///< as the server last heard
  std::set<GoalId> accepted_;
  std::map<GoalId, GoalState> ended_;
  std::map<GoalId, GoalState> seen_;
  std::set<EdgeId> checked_stitches_;
  Contacts contacts_;
};

}  // namespace weft::simulation
