#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/diagnostic.hpp"
#include "core/network/registration.hpp"
#include "core/network/removal.hpp"
#include "core/network/rule.hpp"
#include "core/protocol/peers.hpp"

/// Holds what operators want done, by the server and by robots, and what comes of it.
namespace weft::msg {

inline constexpr std::size_t kReportRows = 1000;     ///< most stretches in a report on what was taught
inline constexpr std::size_t kReportConditions = 4;  ///< most conditions in each of them

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
  /// Labels the experience (teach) or the place (keep_place); teach_report: names the experience, empty: the last
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

/// Names a point of a registered floor plan.
struct PointOnPlan {
  std::string plan;  ///< empty: the only one that is registered
  Eigen::Vector2d point = Eigen::Vector2d::Zero();
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
    /// Takes a snapshot that is then restored beside itself, checked, and compared with the map
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
    goal_hand_over = 32,  ///< from a robot that is not heard to any other
    plan_register = 33,   ///< a floor plan, in the place of an earlier registration of its name
    plan_remove = 34      ///< the registration of a plan, by its name; none: the only one
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
  bool no_return = false;              ///< goal_send, as Goal has them
  Registration registration;           ///< plan_register; plan_remove: the plan's name alone
  std::optional<PointOnPlan> on_plan;  ///< goal_send: where to, instead of by label
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

}  // namespace weft::msg
