#include "clients/cli/invocation.hpp"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <sstream>
#include <utility>

#include "core/names.hpp"
#include "core/polyline.hpp"

namespace weft::cli {
namespace {

using Command = Invocation::Command;

std::string rule(const std::string& what) {
  return what + ": " + std::string(kNameRule);
}

/// Builds the commands; each sets its fields of `into` when it is the one.
class Grammar {
 public:
  Grammar(CLI::App& app, Invocation& into) : app_(app), into_(into) {}

  void all() {
    globals();
    robots();
    map();
    goals();
    rules();
    files();
    add(app_, "calibrate",
        "Find out a robot's camera, or how it is mounted: `weft calibrate --help`; needs no server but weft-agent",
        Command::calibrate);
    add(app_, "doctor", "Look for what is wrong: server, vendors, versions, clocks, disk", Command::doctor);
    // Last, because commands inherit the footer that is there when they are added.
    app_.footer(
        "ROBOT is a robot's name or id. Each command has its own --help. An example, in order:\n"
        "  weft robots; weft teach r1 start --as loop; weft map label here --robot r1 dock; weft teach r1 stop;\n"
        "  weft goal send --to dock; weft goal list; weft goal watch ID; weft map draw map.svg\n"
        "Exit codes: 0 done, 1 failed, 2 wrong usage, 3 no server reached, 4 refused, 5 no answer in time");
  }

 private:
  CLI::App* group(const char* name, const char* help) {
    CLI::App* const group = app_.add_subcommand(name, help);
    group->require_subcommand(1);
    return group;
  }

  CLI::App* add(CLI::App& parent, const char* name, const char* help, Command command) {
    CLI::App* const sub = parent.add_subcommand(name, help);
    sub->add_flag("--json", into_.json, "Print one JSON document");
    sub->callback([this, command] { into_.command = command; });
    return sub;
  }

  void globals() {
    app_.add_option("--server", into_.servers, "Where weft-server listens; repeatable [WEFT_SERVER, or 127.0.0.1]")
        ->type_name("HOST[:INDEX]");
    app_.add_option("--dds", into_.vendor, "fastdds | cyclonedds; any goes with any server [WEFT_DDS, or cyclonedds]")
        ->type_name("VENDOR")
        ->check(CLI::IsMember({"fastdds", "cyclonedds"}).description(""));
    app_.add_option("--domain", into_.domain, "The server's DDS domain, 0 to 200 [0]")
        ->type_name("N")
        ->check(CLI::Range(0U, 200U).description(""));
    app_.add_option("--listen", into_.listen, "Own address or interface, on the network of the server [127.0.0.1]")
        ->type_name("HOST");
    app_.add_option("--timeout", into_.timeout_s,
                    "Seconds to wait for an answer, 0.1 to 86400 [as suits the command]")
        ->type_name("S")
        ->check(CLI::Range(0.1, 86400.0).description(""));
    app_.add_flag("--json", into_.json, "Print one JSON document");
  }

  void robots() {
    add(app_, "robots", "Each robot: what it does, where it is, since when it is silent", Command::robots);

    CLI::App* const teach =
        app_.add_subcommand("teach", "Teach ROBOT: what it sees from start to stop joins the map");
    teach->add_option("ROBOT", into_.robot, "Its name or id")->required()->type_name("");
    teach->require_subcommand(1);
    CLI::App* const start = add(*teach, "start", "Begin an experience", Command::teach_start);
    start->add_option("--as", into_.name, rule("The experience's name"))->type_name("NAME");
    start
        ->add_option("--along", into_.file,
                     "Simulated robots: lead it along the points of FILE, 'x y' a row in the site's metres")
        ->type_name("FILE");
    CLI::App* const stop = add(*teach, "stop", "End the experience", Command::teach_stop);
    stop->add_flag("--replace", into_.replace,
                   "What was taught takes the place of older places that it covers (`weft map replace`)");

    add(*teach, "report", "How what it was taught will be found again, so far or the last time: metre by metre",
        Command::teach_report)
        ->add_option("--draw", into_.file, "A picture of it, *.png or *.svg")
        ->type_name("OUT");

    CLI::App* const localise =
        add(app_, "localise", "Have ROBOT find out where in the map it stands", Command::localise);
    localise->add_option("ROBOT", into_.robot, "Its name or id")->required()->type_name("");
    localise
        ->add_option("--at", into_.place,
                     "LABEL or PLACE near which it stands; without it all it has of the map is searched")
        ->type_name("WHERE");

    stop_or_resume("stop",
                   "Stop ROBOT; its goal is paused. A convenience: people are protected by the base's own safety",
                   Command::stop);
    stop_or_resume("resume", "Let ROBOT drive again", Command::resume);

    CLI::App* const robot = group("robot", "One robot");
    add(*robot, "counts", "How often ROBOT found where it is since its agent started, and what it refused, by reason",
        Command::robot_counts)
        ->add_option("ROBOT", into_.robot, "Its name or id")
        ->required()
        ->type_name("");
    CLI::App* const clear = add(
        *robot, "clear", "Free what ROBOT occupies: only when it has been taken off the floor", Command::robot_clear);
    clear->add_option("ROBOT", into_.robot, "Its name or id")->required()->type_name("");
    clear->add_flag("--yes", into_.is_sure,
                    "Also when ROBOT is heard: its route is freed and its goal fails; where it stands stays held");
    add(*robot, "forget", "ROBOT is gone for good: its name is free, what it taught stays", Command::robot_forget)
        ->add_option("ROBOT", into_.robot, "Its name or id; it must not be heard")
        ->required()
        ->type_name("");
    CLI::App* const rename = add(*robot, "rename", "Call a ROBOT that is not heard NAME", Command::robot_rename);
    rename->add_option("ROBOT", into_.robot, "Its name or id")->required()->type_name("");
    rename->add_option("NAME", into_.name, rule("Its new name"))->required()->type_name("");
  }

  void stop_or_resume(const char* name, const char* help, Command command) {
    CLI::App* const sub = add(app_, name, help, command);
    CLI::Option* const robot = sub->add_option("ROBOT", into_.robot, "Its name or id")->type_name("");
    CLI::Option* const all = sub->add_flag("--all", all_, "Every robot");
    robot->excludes(all);
    // Takes the place of the callback that add() gave.
    sub->callback([this, sub, command] {
      into_.command = command;
      if (into_.robot.empty() && !all_) throw CLI::RequiredError(sub->get_name() + ": ROBOT or --all");
    });
  }

  void map() {
    CLI::App* const map = group("map", "The network");
    add(*map, "info", "How much there is, and what was refused", Command::map_info);
    add(*map, "list", "What was taught and imported: by whom, when, how long, its labels, what it is joined to",
        Command::map_list);
    CLI::App* const draw =
        add(*map, "draw", "Draw the network: runs, stitches, labels, and what each line means", Command::map_draw);
    draw->add_option("OUT", into_.file, "A file, *.png or *.svg")->type_name("")->required();
    draw->add_option("--floor-plan", into_.floor_plan, "Draw it upon a floor plan: a map_server file, with its PGM")
        ->type_name("MAP.yaml");
    anchors(*draw);
    CLI::Option* const robots = draw->add_flag(
        "--robots", into_.draws_robots, "Robots too, where they say they are, what they hold, and their routes");
    revision(*draw, "--at", into_.at, "As the network was at that revision")->excludes(robots);
    CLI::App* const label = add(*map, "label", "Name a place, to send goals to", Command::map_label);
    label->add_option("PLACE", into_.place, "A place's id as `weft map export` writes it, or: here")
        ->type_name("")
        ->required();
    label->add_option("NAME", into_.name, rule("The label"))->type_name("")->required();
    label->add_option("--robot", into_.robot, "With here: the robot that stands there")->type_name("ROBOT");
    label->callback([this] {
      into_.command = Command::map_label;
      const bool here = into_.place == "here";
      if (here && into_.robot.empty()) throw CLI::RequiredError("map label here: --robot ROBOT");
      if (!here && !into_.robot.empty())
        throw CLI::ValidationError("map label PLACE NAME: --robot goes with here only");
    });
    add(*map, "unlabel", "Remove a label; the place stays", Command::map_unlabel)
        ->add_option("NAME", into_.name, "The label")
        ->type_name("")
        ->required();
    CLI::App* const relabel = add(*map, "relabel", "Call a label otherwise", Command::map_relabel);
    relabel->add_option("NAME", into_.name, "The label")->type_name("")->required();
    relabel->add_option("NEW", into_.new_name, rule("Its new name"))->type_name("")->required();
    CLI::App* const exported = add(*map, "export", "Write the network into a file", Command::map_export);
    exported
        ->add_option("OUT", into_.file,
                     "*.g2o | *.geojson (Nav2 route graph) | *.dot | *.graphml | *.tum; any other name: JSON")
        ->type_name("")
        ->required();
    exported
        ->add_option("--experience", into_.experience,
                     "With *.tum: which, by its name, or its id or the beginning of that")
        ->type_name("NAME");
    anchors(*exported);
    revision(*exported, "--at", into_.at, "As the network was at that revision");
    CLI::App* const import =
        add(*map, "import", "Add the network of pose graphs; nobody drives there", Command::map_import);
    import->add_option("FILE", into_.files, "*.g2o; several of one graph are joined")->type_name("")->required();
    import->add_option("--as", into_.name, rule("The import's name, under which it is a repeat"))
        ->type_name("NAME")
        ->required();
    past(*map);
    edits(*map);
    upkeep(*map);
  }

  /// Each makes one revision, which `map undo --revision` takes back.
  void edits(CLI::App& map) {
    CLI::App* const back =
        add(map, "rollback", "The map as it was at a revision; what came since stays stored", Command::map_rollback);
    revision(*back, "REVISION", into_.to, "As `weft map log` shows it")->required()->type_name("");
    only_say(*back);
    CLI::App* const undo =
        add(map, "undo", "Take a stitch, places, an experience or a revision's changes out again", Command::map_undo);
    CLI::Option* const what = what_option(*undo);
    CLI::Option* const which = revision(*undo, "--revision", into_.to, "What that revision changed, instead of WHAT");
    what->excludes(which);
    only_say(*undo);
    undo->callback([this] {
      into_.command = Command::map_undo;
      if (into_.what.empty() && into_.to.value == 0) throw CLI::RequiredError("map undo: WHAT or --revision");
    });
    CLI::App* const quarantine =
        add(map, "quarantine", "Take places or an experience out of the map until you know better",
            Command::map_quarantine);
    what_option(*quarantine)->required();
    only_say(*quarantine);
    apart(map);
    CLI::App* const replace =
        add(map, "replace", "An experience takes the place of older places that it covers", Command::map_replace);
    replace->add_option("EXPERIENCE", into_.what, "Its name or id")->required()->type_name("");
    covering(*replace);
    only_say(*replace);
    CLI::App* const prune =
        add(map, "prune", "Take places out that others cover; says what it would do, and does it with --apply",
            Command::map_prune);
    covering(*prune);
    prune->add_flag("--apply", apply_, "Do it");
    prune->callback([this] {
      into_.command = Command::map_prune;
      into_.only_say = !apply_;
    });
  }

  void apart(CLI::App& map) {
    CLI::App* const apart =
        add(map, "apart", "Vouch that two stretches are different floors: robots there need not wait for each other",
            Command::map_apart);
    CLI::Option* const both =
        apart
            ->add_option("STRETCHES", into_.apart,
                         "Two, each E:I..J (E: 16 hex digits, I and J the first and last place) or a place E:I")
            ->expected(2)
            ->type_name("");
    CLI::Option* const list = apart->add_flag("--list", into_.lists, "Say which stretches are apart");
    list->excludes(both);
    only_say(*apart);
    apart->callback([this] {
      into_.command = Command::map_apart;
      if (into_.apart.empty() && !into_.lists) throw CLI::RequiredError("map apart: two stretches or --list");
    });
  }

  void upkeep(CLI::App& map) {
    add(map, "check", "Read all that is stored, checksums and references, and name what is damaged",
        Command::map_check);
    add(map, "stats", "What takes space in the store", Command::map_stats);
    CLI::App* const snapshot = add(
        map, "snapshot", "Copy the store into a file on the server's machine while it runs", Command::map_snapshot);
    snapshot->add_option("FILE", into_.file, "An absolute path there; it must not exist")->required()->type_name("");
    snapshot->add_flag(
        "--verify", into_.verifies,
        "Then restore it into FILE.verifying, check all of it, compare it with the map, and remove that "
        "folder; needs the room of a second snapshot beside FILE");
    CLI::App* const compact =
        add(map, "compact", "Delete for good what no revision from R on has; there is no way back before R",
            Command::map_compact);
    revision(*compact, "--before", into_.to, "The oldest revision to keep")->required()->type_name("R");
    CLI::App* const restore =
        add(map, "restore", "Make a snapshot the map of a server that does not run; needs no server",
            Command::map_restore);
    restore->add_option("FILE", into_.file, "As `weft map snapshot` wrote it")->required()->type_name("");
    restore->add_option("--store", into_.store, "The server's --store; what was there is kept aside")
        ->required()
        ->type_name("DIR");
    restore->add_flag("--accept-damage", into_.accept_damage, "Of a damaged snapshot, restore what is sound");
  }

  CLI::Option* what_option(CLI::App& sub) {
    return sub
        .add_option("WHAT", into_.what,
                    "A stitch E:I-F:J, a place E:I, places E:I..J (E, F: 16 hex digits), or an experience's "
                    "name or id")
        ->type_name("");
  }
  void only_say(CLI::App& sub) {
    sub.add_flag("--dry-run", into_.only_say, "Say what it would do, and change nothing");
  }
  void covering(CLI::App& sub) {
    sub.add_option("--within", into_.within_m, "How near a place covers another, metres [0.5]")
        ->type_name("M")
        ->check(CLI::Range(0.01, 10.0).description(""));
    sub.add_option("--within-deg", into_.within_deg, "And how alike they look, degrees [20]")
        ->type_name("DEG")
        ->check(CLI::Range(0.1, 180.0).description(""));
  }

  void past(CLI::App& map) {
    CLI::App* const log = add(map, "log", "What each revision changed, when, and who asked", Command::map_log);
    revision(*log, "--newest", into_.to, "Begin with that revision [the latest]");
    log->add_option("--most", into_.most, "How many, 1 to 1000 [20]")
        ->type_name("N")
        ->check(CLI::Range(1U, 1000U).description(""));
    CLI::App* const diff = add(map, "diff", "What came and what went from revision A to B", Command::map_diff);
    revision(*diff, "A", into_.from, "A revision, as `weft map log` shows it")->required()->type_name("");
    revision(*diff, "B", into_.to, "Another one [the latest]")->type_name("");
    diff->add_option("--draw", into_.file, "A picture of it, *.png or *.svg")->type_name("OUT");
  }

  static CLI::Option* revision(CLI::App& sub, const char* name, Revision& into, const char* help) {
    return sub.add_option(name, into.value, help)
        ->type_name("REVISION")
        ->check(CLI::Range(std::uint64_t{1}, std::uint64_t{1} << 62U).description(""));
  }

  void anchors(CLI::App& sub) {
    sub.add_option_function<std::vector<std::string>>(
           "--anchor",
           [this](const std::vector<std::string>& given) {
             for (const std::string& text : given) {
               Result<Anchor> anchor = parse_anchor(text);
               if (!anchor) throw CLI::ValidationError("--anchor " + anchor.error().message);
               into_.anchors.push_back(*std::move(anchor));
             }
           },
           "Where a label lies in the site's frame, metres and radians; repeatable. One needs a heading; several "
           "are fitted by their positions")
        ->type_name("LABEL=X,Y[,HEADING]");
  }

  void files() {
    CLI::App* const file = group("file", "Files of open formats; needs no server");
    add(*file, "info", "Read files and say what is in them, and what is not understood, with its line",
        Command::file_info)
        ->add_option("FILE", into_.files,
                     "*.g2o *.tum *.txt *.csv (EuRoC) *.pcd *.ply *.geojson *.pgm *.png *.yaml; or *.gz")
        ->type_name("")
        ->required();
    CLI::App* const convert =
        add(*file, "convert", "Write clouds as .pcd or .ply, trajectories as .tum, pose graphs joined as .g2o",
            Command::file_convert);
    convert->add_option("IN", into_.files, "What to read; several only for pose graphs")->type_name("")->required();
    convert->add_option("--to", into_.file, "The file to write")->type_name("OUT")->required();
    convert->add_flag("--text", into_.as_text, "Clouds as text");
  }

  void goals() {
    CLI::App* const goal = group("goal", "Goals and their lives");
    CLI::App* const send = add(*goal, "send", "Send a robot to a label; prints the goal's id", Command::goal_send);
    send->add_option("--to", into_.name, "Where: a label of the map")->type_name("LABEL")->required();
    send->add_option("--robot", into_.robot, "Which; otherwise the idle one with the shortest way")
        ->type_name("ROBOT");
    send->add_option("--priority", into_.priority, "Class 0 to 9, 9 the most urgent [0]")
        ->type_name("N")
        ->check(CLI::Range(0U, unsigned{kHighestPriority}).description(""));
    send->add_flag("--no-return", into_.no_return, "Also where no way leads on from: somebody will fetch it");
    add(*goal, "list", "All goals", Command::goal_list);
    one_goal(*goal, "show", "One goal with its history", Command::goal_show);
    one_goal(*goal, "watch", "Follow a goal to its end", Command::goal_watch);
    one_goal(*goal, "cancel", "Call a goal off", Command::goal_cancel);
    one_goal(*goal, "hand-over", "Let another robot have the goal of one that is not heard", Command::goal_hand_over);
    one_goal(*goal, "why", "Why it, or a robot, does not get on: what it waits for, since when, who asked",
             Command::goal_why, "A goal's id or its beginning, or a robot's name");
  }

  /// Each change is one revision, which `map undo --revision` takes back.
  void rules() {
    CLI::App* const rules = group("rule", "What is laid down for pieces of the map");
    CLI::App* const added = add(*rules, "add", "Lay down a rule, or change the one of that name", Command::rule_add);
    added->add_option("NAME", into_.rule.name, rule("Its name"))->required()->type_name("");
    added
        ->add_option_function<std::string>(
            "--kind", [this](const std::string& text) { read_kind(text); },
            "closed | speed=M/S | one_way | priority=N | capacity=N | parking | charging | hold")
        ->required()
        ->type_name("KIND");
    added
        ->add_option("--place", into_.stretches,
                     "Where: places E:I..J of a run (E: 16 hex digits), E:I..F:J over an edge, or E:I; repeatable")
        ->allow_extra_args(false)
        ->type_name("A..B");
    CLI::Option* const label =
        added->add_option("--label", into_.rule.label, "Where: at a label")->type_name("LABEL");
    added->add_option("--within", into_.rule.within_m, "And around it, metres along the ways from and to it [0]")
        ->type_name("M")
        ->check(CLI::Range(0.0, kRuleWithin_m).description(""))
        ->needs(label);
    added->add_flag("--one-direction", into_.rule.one_direction, "With closed: only from A towards B");
    only_say(*added);
    add(*rules, "list", "All rules, and on how many places each holds", Command::rule_list);
    CLI::App* const removed = add(*rules, "remove", "Take a rule away", Command::rule_remove);
    removed->add_option("NAME", into_.rule.name, "The rule")->required()->type_name("");
    only_say(*removed);
    CLI::App* const edge = group("edge", "The way from a place to another one");
    one_edge(*edge, "close", "Let nobody drive from A to B any more: a rule, see weft rule list",
             Command::edge_close);
    one_edge(*edge, "open", "Let robots drive there again", Command::edge_open);
    held(app_, "hold", "Release a ROBOT, or robots on the places of a RULE, no farther; nobody stops harder for it",
         Command::hold);
    held(app_, "unhold", "Let a held ROBOT, or the places of a RULE, go", Command::unhold);
  }

  void one_edge(CLI::App& parent, const char* name, const char* help, Command command) {
    CLI::App* const sub = add(parent, name, help, command);
    sub->add_option("A", into_.place, "A place E:I (E: 16 hex digits)")->required()->type_name("");
    sub->add_option("B", into_.to_place, "A place of the same run, or one that an edge joins it with")
        ->required()
        ->type_name("");
    sub->add_flag("--both", into_.both, "In both directions");
  }

  void held(CLI::App& parent, const char* name, const char* help, Command command) {
    add(parent, name, help, command)
        ->add_option("WHAT", into_.robot, "A robot's name or id, or a rule's name")
        ->required()
        ->type_name("");
  }

  /// Reads "KIND" or "KIND=VALUE".
  void read_kind(const std::string& text) {
    const std::size_t equals = text.find('=');
    const std::optional<RuleKind> kind = rule_kind(text.substr(0, equals));
    if (!kind) {
      throw CLI::ValidationError(
          "--kind " + text +
          " is none of: closed, speed=M/S, one_way, priority=N, capacity=N, parking, charging, hold");
    }
    into_.rule.kind = *kind;
    const bool needs_value = *kind == RuleKind::speed || *kind == RuleKind::priority || *kind == RuleKind::capacity;
    if (needs_value != (equals != std::string::npos)) {
      throw CLI::ValidationError("--kind " + text + (needs_value ? " needs a value: " : " takes no value: ") +
                                 to_string(*kind) + (needs_value ? "=0.5, say" : ""));
    }
    if (!needs_value) return;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + equals + 1, end, into_.rule.value);
    if (error != std::errc{} || stop != end) {
      throw CLI::ValidationError("--kind " + text + ": '" + text.substr(equals + 1) + "' is no number");
    }
  }

  void one_goal(CLI::App& parent, const char* name, const char* help, Command command,
                const char* id = "The goal's id or its beginning") {
    add(parent, name, help, command)->add_option("ID", into_.goal, id)->type_name("")->required();
  }

  CLI::App& app_;
  Invocation& into_;
  bool all_ = false;
  bool apply_ = false;
};

/// Refuses names of a command line that the server would refuse, or could not read, before they leave this machine.
Result<void> check_names(const Invocation& invocation) {
  constexpr std::array kOfLabels = {Command::map_label, Command::goal_send, Command::map_unlabel,
                                    Command::map_relabel};
  const bool is_label = std::ranges::find(kOfLabels, invocation.command) != kOfLabels.end();
  const char* const kind = is_label ? "label" : invocation.command == Command::robot_rename ? "robot" : "name";
  if (!invocation.robot.empty()) {
    if (Result<void> good = check_name("robot", invocation.robot); !good) return good;
  }
  if (!invocation.name.empty()) {
    if (Result<void> good = check_name(kind, invocation.name); !good) return good;
  }
  if (!invocation.rule.name.empty()) {
    if (Result<void> good = check_name("rule", invocation.rule.name); !good) return good;
  }
  if (!invocation.rule.label.empty()) {
    if (Result<void> good = check_name("label", invocation.rule.label); !good) return good;
  }
  if (!invocation.new_name.empty()) {
    if (Result<void> good = check_name("label", invocation.new_name); !good) return good;
  }
  const bool names_label = invocation.command == Command::localise && !invocation.place.empty() &&
                           !parse_place_id(invocation.place).has_value();
  return names_label ? check_name("label", invocation.place) : Result<void>();
}

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts;
  std::istringstream in(text);
  for (std::string part; std::getline(in, part, at);) {
    if (!part.empty()) parts.push_back(part);
  }
  return parts;
}

/// One line. CLI11 misses a subcommand before it looks at what stood in its place, which is what helps most.
std::string mistake(const CLI::App& app, const CLI::ParseError& problem) {
  const std::vector<std::string> strays = app.remaining(true);
  std::string what = problem.what();
  if (!strays.empty() && what.find(strays.front()) == std::string::npos) {
    what = "'" + strays.front() + "' is not understood here (" + what + ")";
  }
  return "weft: " + what + "; see weft --help\n";
}

}  // namespace

std::variant<Invocation, NotRun> parse(int argc, const char* const* argv, const Environment& environment) {
  Invocation invocation;
  if (argc > 1 && std::string_view(argv[1]) == "calibrate") {  // its words are the other program's to understand
    invocation.command = Command::calibrate;
    invocation.passed.assign(argv + 2, argv + argc);
    return invocation;
  }
  invocation.vendor = environment.vendor.empty() ? "cyclonedds" : environment.vendor;
  invocation.servers = split(environment.server, ',');
  invocation.listen = "127.0.0.1";
  CLI::App app("The operator's command: talks to the fleet map server, weft-server.", "weft");
  app.require_subcommand(1);
  app.fallthrough();
  Grammar grammar(app, invocation);
  grammar.all();
  const bool wants_json =
      std::any_of(argv, argv + argc, [](const char* word) { return std::string_view(word) == "--json"; });
  app.set_version_flag("--version", "weft " WEFT_VERSION + environment.libraries);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& problem) {
    std::ostringstream out;
    std::ostringstream err;
    if (app.exit(problem, out, err) == 0) return NotRun{0, out.str()};
    return NotRun{2, mistake(app, problem), wants_json};
  }
  if (const Result<void> good = check_names(invocation); !good) {
    return NotRun{2, "weft: " + good.error().message + "\n", wants_json};
  }
  if (invocation.servers.empty()) invocation.servers.emplace_back("127.0.0.1");
  return invocation;
}

Result<std::vector<msg::AgentCommand::Point>> parse_polyline(std::string_view text, const std::string& file) {
  const Result<std::vector<PolylinePoint>> read = parse_polyline_points(text, file);
  if (!read) return fail(read.error());
  if (read->size() < 2) return fail(ErrorCode::invalid, file + ": fewer than two points, nothing to drive along");
  std::vector<msg::AgentCommand::Point> points;
  for (const auto& [x, y] : *read) points.push_back({x, y});
  return points;
}

}  // namespace weft::cli
