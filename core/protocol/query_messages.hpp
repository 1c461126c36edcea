#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/network/goal.hpp"
#include "core/network/page.hpp"
#include "core/network/registration.hpp"
#include "core/network/rule.hpp"
#include "core/protocol/alarms.hpp"
#include "core/protocol/robot_messages.hpp"

/// Holds what can be asked of the server, its answers, and events.
namespace weft::msg {

/// Asks the server for something to read; client to server. Changes nothing.
struct Query {
  enum class Kind : std::uint8_t {
    robots = 1,
    goals = 2,
    info = 3,
    events = 4,
    log = 5,
    network = 6,
    experiences = 7,
    rules = 8,
    registrations = 9,
    alarms = 10
  };
  Header header;
  std::uint64_t request = 0;
  Kind kind = Kind::robots;
  GoalId goal;            ///< goals, events: only this one; none: all
  std::string robot;      ///< events: only this one
  Revision newest;        ///< log: from here back; 0: from the latest
  std::uint32_t most{};   ///< log, events: how many at most, up to 1000; events: 0: 1000
  Revision at{};          ///< network: as it was then; 0: as it is
  Revision apart_from{};  ///< network: only experiences that differ from those of that revision; 0: all
  PlaceId after{};        ///< network: the page behind that place; none: the first
  /// events: of this kind or of those that it begins up to a dot ("robot": robot.lost and its like); empty: of all
  std::string event_kind{};
  WallTime since{};             ///< events: not before that; 1970: from the first
  std::uint64_t after_event{};  ///< events: behind that number; 0: from the first
};

struct Event {
  WallTime at{};
  std::string kind;  ///< dotted, e.g. goal.assigned, robot.lost, intake.refused
  RobotId robot;
  GoalId goal;
  std::string cause;
  std::string who;
  std::uint64_t number = 0;  ///< counts up from 1 in the order in which events were kept; 0: it is not kept
};

/// Tells people what a revision did: a line of the map's log.
struct RevisionNote {
  Revision revision;
  Revision base;      ///< what it stands on: the one before it, or the one that was gone back to
  WallTime at{};      ///< 1970: not known
  std::string kind;   ///< batch, label, seal, undo, quarantine, rollback, ...
  std::string who;    ///< who asked
  std::string cause;  ///< what exactly, and why
  bool operator==(const RevisionNote&) const = default;
};

/// Describes a robot that stands with a route, and cannot have the next piece of it.
struct RobotWait {
  PlaceId at;                    ///< none: it does not wait
  PlaceId needs;                 ///< the first place that it cannot have; none: its wait is not for a place
  std::vector<RobotId> held_by;  ///< all that have to leave before it goes on
  WallTime since{};
  std::string rule;  ///< name of the rule that keeps it from there; empty: none does
};
inline constexpr std::size_t kHoldersTold = 1000;

struct RobotRow {
  RobotDescription description;
  RobotState state;
  double silent_s = 0.0;  ///< by the server's steady clock
  bool is_heard = false;  ///< does not count as silent
  std::string vendor;
  std::string software;  ///< the agent's version
  double clock_skew_s = 0.0;
  std::string occupies;               ///< for people: from place to place
  std::uint64_t window_bytes = 0;     ///< sent to it since the server started: its window's patches
  std::uint64_t content_bytes = 0;    ///< the same of contents
  std::uint64_t messages_heard = 0;   ///< of its agent's present start
  std::uint64_t messages_missed = 0;  ///< of those that it sent meanwhile: lost, or overtaken by newer ones
  RobotWait wait;
  std::string standstill;  ///< that it is in or waits behind, and what would help; empty: there is none
  RobotPower power;        ///< the last that it said; no sender: it has said nothing
  std::string held_by;     ///< who holds it (weft hold); empty: nobody
  std::string plan;        ///< the registered floor plan on which it stands; empty: none, or it is not known where
  Pose2 plan_from_robot;   ///< with a plan
  bool is_twin = false;    ///< two live agents have its id: it is held
  bool is_deaf = false;    ///< it is heard, and has heard nothing of the server for kDeaf_s
  bool is_window_current = false;  ///< it holds, by its own digest, what the newest network has for its window
};

struct MapInfo {
  Revision revision;
  Epoch epoch;
  std::uint64_t experiences = 0, places = 0, stitches = 0, contents = 0, content_bytes = 0;
  std::uint64_t batches_acknowledged = 0, batches_refused = 0;
  std::uint64_t disk_free_bytes = 0;
  std::string software, vendor, engine;  ///< engine: sqlite | memory
  std::string stopped;                   ///< why the store takes nothing now; empty: it works
  std::string unjoined;  ///< robots in parts of the map that nothing joins, and what to do; empty: there are none
  std::vector<std::pair<std::string, std::uint64_t>> counters;  ///< refused messages by reason, and the like
};

/// Describes one experience of the map for people.
struct ExperienceRow {
  ExperienceId id;
  std::string name;  ///< may be empty
  RobotId robot;     ///< or the import that it came with
  std::string method;
  bool sealed = false;
  std::uint32_t places = 0;
  double metres = 0.0;  ///< along it
  WallTime begun{};     ///< 1970: not known
  std::vector<std::string> labels;
  std::vector<std::string> leads_nowhere;  ///< those of the labels that no robot could leave again
  std::vector<ExperienceId> joined;        ///< those that a stitch leads to, up to kJoinedTold
  std::uint32_t joined_count = 0;
};
inline constexpr std::size_t kJoinedTold = 200;

/// Holds one label that waits for a place which its robot has not handed in, for people.
struct AwaitedLabelRow {
  std::string label;
  PlaceId place;
  RobotId robot;    ///< that keeps the place
  std::string who;  ///< gave it: the client's name
};

/// Holds one rule, for people.
struct RuleRow {
  Rule rule;
  std::uint32_t places = 0;  ///< of the map that it holds on
  std::string problem;       ///< why it holds on none, or on fewer than it names; empty: it does
};

/// Holds one registered floor plan, and how the map lies on it, for people.
struct RegistrationRow {
  Registration registration;
  /// Tells what became of a pick.
  enum class PickState : std::uint8_t { counts = 1, left_out = 2, gone = 3 };
  struct PickRow {
    PickState state = PickState::counts;
    double off_m = 0.0;  ///< from where it was picked
  };
  std::vector<PickRow> picks;    ///< in the order of the registration's; none while it is worked out
  std::uint64_t places = 0;      ///< that lie on the plan
  std::uint64_t all_places = 0;  ///< of the map; those of parts without picks have no pose on the plan
  double scale = 1.0;            ///< metres of the plan for one of the map, which fit best; never applied
  double sigma_m = 0.0;          ///< of the position in the middle of the picks
  std::string text;              ///< all of that in words
  std::string problem;           ///< why no place lies on the plan; empty: they do
};

/// Foretells when a robot comes to its goal, in seconds from now.
struct Arrival {
  GoalId goal;
  double in_s = 0.0;
  double soonest_s = 0.0;  ///< with latest_s: four of five robots come between the two
  double latest_s = 0.0;
};

struct QueryReply {
  Header header;
  PeerId to;
  std::uint64_t request = 0;
  std::uint32_t part = 0;
  std::uint32_t parts = 1;
  std::vector<RobotRow> robots;
  std::vector<Goal> goals;
  std::vector<Route> routes;      ///< the latest route of each goal above
  std::vector<Arrival> arrivals;  ///< of the goals above to which a robot is on its way
  /// The newest that the query asks for; the first behind a number or a time when it names one. 1000 at most
  std::vector<Event> events;
  std::uint64_t oldest_event =
      0;  ///< events: the number of the oldest that the server keeps of all; 0: it keeps none
  std::uint64_t newest_event = 0;  ///< events: the same of the newest
  std::vector<Alarm> alarms;
  MapInfo info;
  std::vector<RevisionNote> log;  ///< newest first
  NetworkPage network;            ///< a piece of one page in each part
  std::vector<ExperienceRow> experiences;
  std::vector<AwaitedLabelRow> awaited_labels;  ///< beside experiences
  std::vector<RuleRow> rules;
  std::vector<RegistrationRow> registrations;
  Outcome outcome = Outcome::done;  ///< else nothing but `message` counts: why there is no answer, and what to do
  std::string message;
};

/// Announces to logs and watchers that something happened. A note that was lost on the way can be asked for with
/// Query, unless the store could not keep the event.
struct EventNote {
  Header header;
  Event event;  ///< without its number
  bool is_kept = true;
};

}  // namespace weft::msg
