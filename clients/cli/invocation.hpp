#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "clients/cli/anchor.hpp"
#include "clients/cli/polygon.hpp"
#include "clients/cli/since.hpp"
#include "clients/cli/thin_cloud.hpp"
#include "core/protocol/messages.hpp"
#include "core/result.hpp"

namespace weft::cli {

/// Describes one command line, understood.
struct Invocation {
  enum class Command {
    robots,
    teach_start,
    teach_stop,
    teach_report,
    localise,
    map_info,
    map_draw,
    map_label,
    map_export,
    map_import,
    map_log,
    map_diff,
    map_rollback,
    map_undo,
    map_quarantine,
    map_apart,
    map_replace,
    map_prune,
    map_compact,
    map_snapshot,
    map_check,
    map_stats,
    map_restore,
    goal_send,
    goal_list,
    goal_show,
    goal_watch,
    goal_cancel,
    goal_hand_over,
    goal_why,
    stop,
    resume,
    robot_clear,
    robot_counts,
    robot_forget,
    robot_rename,
    map_list,
    map_unlabel,
    map_relabel,
    doctor,
    file_info,
    file_convert,
    calibrate,
    rule_add,
    rule_list,
    rule_refresh,
    rule_remove,
    edge_close,
    edge_open,
    hold,
    unhold,
    map_register,
    events,
    alarms,
    bundle,
    doctor_network,
    doctor_fleet
  };
  Command command = Command::robots;
  std::string robot;               ///< name or hex id; empty: any, or all
  std::string name;                ///< of an experience or a label
  std::string new_name;            ///< map relabel
  std::string place;               ///< a place id, a label, or "here"
  std::string goal;                ///< an id, the unique beginning of one, or (why) a robot's name
  std::string file;                ///< to read (--along) or to write
  std::vector<std::string> files;  ///< to read
  std::string floor_plan;          ///< map draw, map register: a map_server file; empty: none
  std::vector<Anchor> anchors;     ///< map draw, map export, map register: where labels lie in the site
  std::string experience;          ///< map export: a name, an id or its beginning
  bool draws_robots = false;       ///< map draw: robots too, and what they hold
  bool draws_mosaic = false;       ///< map draw: the patches of places in place of the network
  bool draws_clouds = false;       ///< map draw: the clouds of places in place of the network
  Revision at;                     ///< map draw, map export: as it was then; 0: as it is
  Revision from, to;               ///< map diff; map log: the newest to show (to)
  std::uint32_t most = 20;         ///< map log: how many
  std::string what;                ///< map undo, quarantine, replace: a stitch, places, an experience's name or id
  bool is_sure = false;            ///< robot clear: also when the robot is heard
  bool only_say = false;           ///< map edits: say what would be done
  std::string store;               ///< map restore: the server's directory
  bool accept_damage = false;      ///< map restore: of a damaged snapshot what is sound
  bool verifies = false;           ///< map snapshot: see whether it restores
  bool lists = false;              ///< map apart, map register: say which are
  std::vector<std::string> apart;  ///< map apart: the two stretches
  bool replace = false;            ///< teach stop: what was taught takes the place of what it covers
  double within_m = 0.0;           ///< map prune, replace: as usual when 0
  double within_deg = 0.0;
  bool as_text = false;             ///< file convert: clouds as text
  Thinning thinning;                ///< file convert: of clouds
  std::vector<std::string> passed;  ///< calibrate: as it stands, for `weft-agent calibrate`
  Rule rule;  ///< rule add: all but its spans; rule remove, refresh: its name (refresh: none: all)
  std::vector<std::string> stretches;      ///< rule add: its spans
  Polygon polygon;                         ///< rule add: where on a registered plan
  std::string to_place;                    ///< edge close, edge open: where it leads
  bool both = false;                       ///< edge close, edge open: in both directions
  unsigned priority = 0;                   ///< goal send
  bool no_return = false;                  ///< goal send
  std::optional<Eigen::Vector2d> to_plan;  ///< goal send: a point of a registered plan
  std::string plan;       ///< goal send, map export, map draw, rule add: which registered plan; empty: the only one
  bool no_plan = false;   ///< map export, map draw: in no plan's frame
  bool removes = false;   ///< map register: remove it
  double sigma_m = 0.05;  ///< map register: of each pick
  std::optional<Since> since;         ///< events: none: the last few
  std::string event_kind;             ///< events: its beginning, up to a dot; empty: all
  unsigned last = 100;                ///< events: how many, without `since`
  bool follows = false;               ///< events: go on until interrupted
  std::vector<std::string> logs;      ///< bundle: files besides this machine's journal
  std::vector<std::string> settings;  ///< bundle: files besides those in /etc/weft
  bool json = false;

  std::vector<std::string> servers;
  std::string vendor;
  unsigned domain = 0;
  std::string listen;
  std::optional<double> timeout_s;  ///< none: what suits the command
};

/// Describes a command line that is not to be run: help, or a mistake with what to do.
struct NotRun {
  int exit_code = 2;
  std::string text;
  bool json = false;  ///< a mistake is wanted as a document
};

/// Holds defaults from the environment: WEFT_SERVER (comma-separated), WEFT_DDS, WEFT_LISTEN, WEFT_DOMAIN.
struct Environment {
  std::string server = {};
  std::string vendor = {};
  std::string listen = {};
  std::string domain = {};
  std::string libraries = {};  ///< what --version names beside weft itself
};

std::variant<Invocation, NotRun> parse(int argc, const char* const* argv, const Environment& environment);

/// Reads a polyline, one point "x y" or "x,y" a line, metres in the site's frame; '#' begins a comment.
/// invalid: there are fewer than two points, or a line is wrong; names the file, the line and what is wrong.
Result<std::vector<msg::AgentCommand::Point>> parse_polyline(std::string_view text, const std::string& file);

}  // namespace weft::cli
