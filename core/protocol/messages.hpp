#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/bytes.hpp"
#include "core/diagnostic.hpp"
#include "core/network/change.hpp"
#include "core/network/goal.hpp"
#include "core/network/page.hpp"
#include "core/network/removal.hpp"
#include "core/network/rule.hpp"
#include "core/network/window.hpp"
#include "core/safety.hpp"

/// Holds the messages that cross the wire, as the inside of every process knows them; nothing else crosses it. The
/// IDL of the same names is in idl/. `to` names the peer that a message is for.
namespace weft::msg {

inline constexpr std::uint16_t kProtocolVersion = 1;
inline constexpr std::size_t kChunkBytes = 65'536;               ///< most data in one chunk
inline constexpr std::uint64_t kContentBytes = kLargestContent;  ///< largest content or cloud
inline constexpr std::size_t kPatchEntities = 500;               ///< most places + edges + removals in one patch part
inline constexpr std::size_t kSignatureNumbers = 1024;           ///< longest signature of what a robot sees
inline constexpr std::size_t kRecognisedPlaces = 200;            ///< most places that are proposed for one signature
inline constexpr std::size_t kRecognisedRank = 10'000;  ///< no place behind so many likelier ones is proposed
inline constexpr std::size_t kReportRows = 1000;        ///< most stretches in a report on what was taught
inline constexpr std::size_t kReportConditions = 4;     ///< most conditions in each of them

/// Says who speaks, and under which server's authority; stands in every message that claims authority.
struct Header {
  PeerId sender;
  std::uint64_t incarnation = 0;  ///< random at each start of the sender: two live ones of one id raise an alarm
  Epoch epoch;                    ///< the server's, as the sender knows it; 0 before the first hello
  std::uint64_t sequence = 0;     ///< counts this sender's messages of this incarnation
  Bytes signature;                ///< room for one; empty today, at most 64 bytes
};

enum class Role : std::uint8_t { server = 1, agent = 2, client = 3 };

/// Tells what came of a request. under_way: long work has come so far; another reply follows.
enum class Outcome : std::uint8_t { done = 1, accepted = 2, refused = 3, failed = 4, under_way = 5 };

inline constexpr std::size_t kAnswers = 32;  ///< challenges in a server's hello

/// Introduces a peer. Frozen for ever: every version can read it. Late joiners get the last one of each peer.
struct Hello {
  PeerId peer;
  std::uint64_t incarnation = 0;
  Role role = Role::agent;
  std::uint16_t protocol_min = kProtocolVersion;
  std::uint16_t protocol_max = kProtocolVersion;
  Epoch epoch;  ///< a server's own; 0 from others
  std::string name;
  std::string software;  ///< version for people
  std::string vendor;    ///< fastdds | cyclonedds | inprocess, as the bus names itself
  /// Asks the server to prove that it lives: random, to be repeated in its next hello. Of agents, clients; 0: none.
  std::uint64_t challenge = 0;
  /// Repeats the challenges last heard, at most kAnswers; a server's only. Proves that it lives, and hears the asker.
  std::vector<std::uint64_t> answers{};
};

struct Camera {
  std::string id;
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::string calibration;
};

struct RobotDescription {
  Header header;
  std::string name;
  std::string body;                  ///< sim | replay | ...
  std::vector<std::string> methods;  ///< what it can drive
  double footprint_radius_m = 0.4;
  bool can_be_taught_along = false;  ///< a simulated body's hand follows a polyline
  std::vector<Camera> cameras;
  bool knows_limits = false;  ///< keeps to Route::limits; otherwise it is not released where a limit holds
};

enum class RobotMode : std::uint8_t {
  idle = 1,
  teaching = 2,
  driving = 3,
  waiting = 4,
  stopped = 5,
  lost = 6,
  faulted = 7,
  off = 8  ///< the agent's last word: its process was ended
};
const char* to_string(RobotMode mode);

struct RobotState {
  Header header;
  std::string name;
  RobotMode mode = RobotMode::idle;
  bool localised = false;
  PlaceId place;  ///< nearest known; none when not localised
  Relation place_from_robot;
  double blind_m = 0.0;  ///< driven since the last fix
  double speed_m_s = 0.0;
  std::uint64_t frame = 0;
  ExperienceId experience;  ///< being taught; none otherwise
  GoalId goal;
  RouteId route;
  std::uint32_t route_version = 0;
  Revision window_revision;
  Digest window_digest;
  std::uint64_t contents_missing = 0;   ///< of its window
  std::uint64_t memory_bytes = 0;       ///< of contents that it holds
  std::uint64_t memory_cap_bytes = 0;   ///< it never holds more
  std::vector<Diagnostic> diagnostics;  ///< what driving has shown of the robot: its camera's mount
  Safety safety = Safety::ok;           ///< as its base says
  std::string reason;                   ///< why it stands, when it stands
};

/// Tells what a robot's battery holds; of bodies that know it.
struct RobotPower {
  Header header;
  double share = 0.0;  ///< of full
  bool is_charging = false;
  std::optional<double> minutes;  ///< until it is empty, or full when it charges; none: not known
};

struct ExperienceBatch {
  Header header;
  Batch batch;
};

struct BatchAck {
  Header header;
  RobotId to;
  ExperienceId experience;
  std::uint64_t durable_through = 0;   ///< every batch up to this one is on disk with its contents
  std::vector<ContentHash> missing;    ///< of the next batch
  std::uint64_t refused_sequence = 0;  ///< 0: none
  std::string refusal;
};

enum class ContentKind : std::uint8_t { content = 1, cloud = 2 };

/// Tells how a content's bytes are coded in a store and on the wire (docs/formats/store.md). raw: as they are.
enum class Coding : std::uint8_t { raw = 0, zstd = 1, cloud = 2 };

/// Carries a piece of a content or cloud; pieces come in any order, any number of times. Agents send raw bytes, the
/// server those it keeps: who gets them expands them and verifies the hash, which is that of the content itself.
struct Chunk {
  Header header;
  PeerId to;
  ContentKind kind = ContentKind::content;
  Coding coding = Coding::raw;
  ContentHash hash;
  std::uint64_t total = 0;   ///< of the coded bytes
  std::uint64_t offset = 0;  ///< among the coded bytes
  Bytes data;
};

/// Asks for contents, each from an offset on, which counts the bytes as they travel (coded).
struct ContentRequest {
  struct Item {
    ContentHash hash;
    std::uint64_t offset = 0;
  };
  Header header;
  PeerId to;
  std::vector<Item> items;
};

struct WindowRequest {
  Header header;
  std::uint64_t definition_id = 0;  ///< the asker's number for this definition; patches carry it back
  WindowDefinition definition;
  Revision held;  ///< 0: nothing
  Digest held_digest;
};

/// Carries a patch of a window, or one of its parts: all parts of one patch share base, target and digest.
struct WindowPatch {
  Header header;
  PeerId to;
  std::uint64_t definition_id = 0;
  std::uint32_t part = 0;
  std::uint32_t parts = 1;
  Patch patch;
};

/// Asks which places of the whole network look like what a robot sees; it does not know where it is. Has a signature.
struct Recognise {
  Header header;
  std::uint64_t request = 0;  ///< the asker's number for it; the answer carries it back
  std::string method;         ///< that signed, and the format of the contents that it signs
  std::uint32_t content_format = 0;
  std::vector<float> seen;  ///< as Method::sign gives it; finite, at least one number
  std::uint32_t most = 0;   ///< places wanted, at least 1
  std::uint32_t after = 0;  ///< the so many likeliest are known already: the ones behind them
};

/// Proposes places to look at, the likeliest first and no two close together. Only those that are signed were
/// compared: a server that has just started, or just been given contents, has not signed all of them yet.
struct Recognised {
  Header header;
  RobotId to;
  std::uint64_t request = 0;
  Outcome outcome = Outcome::done;  ///< done or refused
  std::string message;              ///< why it is refused
  std::vector<PlaceId> places;
  std::uint64_t signed_places = 0;    ///< of the network, with the asker's method and format
  std::uint64_t unsigned_places = 0;  ///< the same, still to be signed
};

struct RouteOrder {
  Header header;
  RobotId to;
  Route route;
};

enum class RoutePhase : std::uint8_t { accepted = 1, driving = 2, waiting = 3, arrived = 4, stopped = 5, failed = 6 };
const char* to_string(RoutePhase phase);

struct RouteProgress {
  Header header;
  GoalId goal;
  RouteId route;
  std::uint32_t version = 0;
  RoutePhase phase = RoutePhase::accepted;
  std::uint32_t at = 0;        ///< index of the last place passed
  std::uint32_t freed = 0;     ///< everything before this index is no longer touched
  std::uint32_t released = 0;  ///< as the robot knows it
  Relation goal_from_robot;    ///< when arrived: as believed
  std::string reason;
};

/// Tells one robot what an operator wants of it; server to agent. Repeats have the same id and are done once.
struct AgentCommand {
  enum class Kind : std::uint8_t {
    teach_start = 1,
    teach_stop = 2,
    localise = 3,
    stop = 4,
    resume = 5,
    keep_place = 6,
    teach_report = 7,
    counts = 8
  };
  struct Point {
    double x = 0.0;
    double y = 0.0;
  };
  Header header;
  RobotId to;
  std::uint64_t command = 0;
  Kind kind = Kind::stop;
  /// teach: labels the experience; keep_place: the place; teach_report: names the experience, empty: the last
  std::string name;
  std::optional<PlaceId> seed;  ///< localise, teach: where the robot stands, roughly
  std::vector<Point> along;     ///< teach on a simulated body: the hand's polyline, metres, site frame
};

/// Predicts how well a robot will find itself on a stretch that it was taught.
struct TaughtStretch {
  double from_m = 0.0;  ///< along the experience
  double to_m = 0.0;
  std::uint32_t places = 0;  ///< kept on it
  PlaceId first;
  std::vector<Diagnostic> found;  ///< the share of its places that are found again, by condition; as they are first
  double sigma_m = 0.0;           ///< predicted of a position found there, metres
  std::string reason;             ///< the most frequent refusal; empty: none
  bool operator==(const TaughtStretch&) const = default;
};

struct AgentReply {
  Header header;
  std::uint64_t command = 0;
  bool done = false;  ///< false: refused, reason says why
  std::string reason;
  PlaceId place;            ///< keep_place: the new place
  ExperienceId experience;  ///< teach, teach_report: which
  std::vector<TaughtStretch> report;
  std::vector<std::pair<std::string, std::uint64_t>> counts;  ///< counts: since the agent started, by name
};

/// Describes what is to be done to the map; which fields count depends on the request's kind.
struct MapWork {
  Revision revision;        ///< rollback: to which; undo: which; compact: before which
  Removal what;             ///< undo, quarantine: when not by revision or name; apart: the two stretches
  bool only_say = false;    ///< say what it would do, and leave the map as it is
  double within_m = 0.0;    ///< replace, prune: how near another place covers the same ground; 0: as usual
  double within_rad = 0.0;  ///< the same for headings
  std::string file;         ///< snapshot: where on the server's machine
};

/// Asks the server to do something. A repeat (same sender, same request) gets the same answer and is done once.
struct OperatorRequest {
  enum class Kind : std::uint8_t {
    goal_send = 1,
    goal_cancel = 2,
    teach_start = 3,
    teach_stop = 4,
    localise = 5,
    stop = 6,
    resume = 7,
    label = 8,
    label_here = 9,
    clear = 10,
    rollback = 11,      ///< the map as it was at a revision, as a new one
    undo = 12,          ///< a stitch, an experience, or what a revision changed
    quarantine = 13,    ///< places out of the map until that is undone
    replace = 14,       ///< an experience takes the place of what it covers
    prune = 15,         ///< places that others cover go
    compact = 16,       ///< delete for good what no revision from there on has
    snapshot = 17,      ///< a copy of the store into a file
    check = 18,         ///< every checksum and reference
    stats = 19,         ///< what takes space
    teach_report = 20,  ///< how well a robot will find itself where it was taught
    robot_counts = 21,  ///< how often a robot found where it is, and what it refused, by reason
    /// takes a snapshot that is then restored beside itself, checked, and compared with the map
    snapshot_verified = 22,
    apart = 23,   ///< the two stretches are different floors
    forget = 24,  ///< a robot that is gone: what it taught stays
    rename = 25,  ///< a robot that is not heard
    label_remove = 26,
    label_rename = 27,
    rule_put = 28,     ///< in the place of the rule with that name, if there is one
    rule_remove = 29,  ///< by its name
    hold = 30,         ///< a robot or the places of a rule: releases stop growing
    unhold = 31,
    goal_hand_over = 32  ///< from a robot that is not heard to any other
  };
  Header header;
  std::uint64_t request = 0;  ///< the client's number for it, random
  Kind kind = Kind::goal_send;
  std::string who;    ///< the operator's name, as events show it; empty: as the client's hello said
  std::string robot;  ///< name or hex id; empty: any, or all for stop and resume; hold, unhold: or a rule's name
  /// Names, by kind: goal_send: where to; label, label_remove, label_rename, rename: its name; localise: a seed;
  /// teach: its name; undo, quarantine, replace, teach_report: an experience's name or hex id
  std::string label;
  std::string new_label;  ///< label_rename
  PlaceId place;          ///< label, localise: which place, when not by label
  GoalId goal;            ///< goal_cancel, goal_hand_over; goal_send: the id to be, drawn by the client
  std::vector<AgentCommand::Point> along;
  MapWork work;
  bool is_sure = false;  ///< clear: also when the robot is heard
  Rule rule;             ///< rule_put; rule_remove: its name alone
  std::uint8_t priority = 0;
  bool no_return = false;  ///< goal_send, as Goal has them
};

struct OperatorReply {
  Header header;
  PeerId to;
  std::uint64_t request = 0;
  Outcome outcome = Outcome::done;
  std::string message;  ///< what happened, and when refused what to do
  GoalId goal;
  PlaceId place;
  ExperienceId experience;
  Revision revision;                                          ///< the one that an edit of the map made; 0: none
  std::uint64_t done = 0, total = 0;                          ///< of long work; total 0: not known
  std::string unit;                                           ///< of `done` and `total`, for people
  std::vector<std::string> findings;                          ///< new since the last reply
  std::vector<std::pair<std::string, std::uint64_t>> counts;  ///< stats; robot_counts: the robot's
  std::vector<TaughtStretch> report;                          ///< teach_report: the robot's
};

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
    rules = 8
  };
  Header header;
  std::uint64_t request = 0;
  Kind kind = Kind::robots;
  GoalId goal;            ///< goals, events: only this one; none: all
  std::string robot;      ///< events: only this one
  Revision newest;        ///< log: from here back; 0: from the latest
  std::uint32_t most{};   ///< log: how many at most, up to 1000
  Revision at{};          ///< network: as it was then; 0: as it is
  Revision apart_from{};  ///< network: only experiences that differ from those of that revision; 0: all
  PlaceId after{};        ///< network: the page behind that place; none: the first
};

struct Event {
  WallTime at{};
  std::string kind;  ///< dotted, e.g. goal.assigned, robot.lost, intake.refused
  RobotId robot;
  GoalId goal;
  std::string cause;
  std::string who;
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
  std::string occupies;             ///< for people: from place to place
  std::uint64_t window_bytes = 0;   ///< sent to it since the server started: its window's patches
  std::uint64_t content_bytes = 0;  ///< the same of contents
  RobotWait wait;
  std::string standstill;  ///< that it is in or waits behind, and what would help; empty: there is none
  RobotPower power;        ///< the last that it said; no sender: it has said nothing
  std::string held_by;     ///< who holds it (weft hold); empty: nobody
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

/// Holds one rule, for people.
struct RuleRow {
  Rule rule;
  std::uint32_t places = 0;  ///< of the map that it holds on
  std::string problem;       ///< why it holds on none, or on fewer than it names; empty: it does
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
  std::vector<Event> events;
  MapInfo info;
  std::vector<RevisionNote> log;  ///< newest first
  NetworkPage network;            ///< a piece of one page in each part
  std::vector<ExperienceRow> experiences;
  std::vector<RuleRow> rules;
  Outcome outcome = Outcome::done;  ///< else nothing but `message` counts: why there is no answer, and what to do
  std::string message;
};

/// Announces to logs and watchers that something happened. Lost ones can be asked for again by Query.
struct EventNote {
  Header header;
  Event event;
};

struct ClockProbe {
  Header header;
  PeerId to;
  std::uint64_t probe = 0;
  WallTime sent{};
};
struct ClockReply {
  Header header;
  std::uint64_t probe = 0;
  WallTime probe_sent{};
  WallTime received{};
  WallTime replied{};
};

using Message =
    std::variant<Hello, RobotDescription, RobotState, ExperienceBatch, BatchAck, Chunk, ContentRequest, WindowRequest,
                 WindowPatch, Recognise, Recognised, RouteOrder, RouteProgress, AgentCommand, AgentReply,
                 OperatorRequest, OperatorReply, Query, QueryReply, EventNote, ClockProbe, ClockReply, RobotPower>;

}  // namespace weft::msg
