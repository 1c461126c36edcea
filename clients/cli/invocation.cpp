#include "clients/cli/invocation.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <sstream>
#include <utility>

namespace weft::cli {
namespace {

using Command = Invocation::Command;

/// Builds the commands; each sets its fields of `into` when it is the one.
class Grammar {
 public:
  Grammar(CLI::App& app, Invocation& into) : app_(app), into_(into) {}

  void all() {
    globals();
    robots();
    map();
    goals();
    add(app_, "doctor", "Look for what is wrong: server, vendors, versions, clocks, disk", Command::doctor);
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
    app_.add_option("--server", into_.servers, "The server's address, HOST or HOST:INDEX; repeatable [WEFT_SERVER]");
    app_.add_option("--dds", into_.vendor, "fastdds or cyclonedds [WEFT_DDS]")
        ->check(CLI::IsMember({"fastdds", "cyclonedds"}));
    app_.add_option("--domain", into_.domain, "DDS domain")->check(CLI::Range(0U, 200U));
    app_.add_option("--listen", into_.listen, "Own address to bind to");
    app_.add_option("--timeout", into_.timeout_s, "Seconds to wait for an answer")->check(CLI::Range(0.1, 86400.0));
    app_.add_flag("--json", into_.json, "Print one JSON document");
    app_.set_version_flag("--version", "weft " WEFT_VERSION);
  }

  void robots() {
    add(app_, "robots", "Each robot: what it does, where it is, since when it is silent", Command::robots);

    CLI::App* const teach =
        app_.add_subcommand("teach", "Teach ROBOT: what it sees from start to stop joins the map");
    teach->add_option("ROBOT", into_.robot)->required();
    teach->require_subcommand(1);
    CLI::App* const start = add(*teach, "start", "Begin an experience", Command::teach_start);
    start->add_option("--as", into_.name, "The experience's name");
    start->add_option("--along", into_.file, "Simulated robots: a polyline to be led along, 'x y' a line");
    add(*teach, "stop", "End the experience", Command::teach_stop);

    CLI::App* const localise = add(app_, "localise", "Have ROBOT look for itself in its map", Command::localise);
    localise->add_option("ROBOT", into_.robot)->required();
    localise->add_option("--at", into_.place, "LABEL or PLACE near which it stands");

    stop_or_resume("stop", "Stop ROBOT; its goal is paused", Command::stop);
    stop_or_resume("resume", "Let ROBOT drive again", Command::resume);

    CLI::App* const clear =
        add(*group("robot", "Robots that need help"), "clear",
            "Free what ROBOT occupies: only when it has been taken off the floor", Command::robot_clear);
    clear->add_option("ROBOT", into_.robot)->required();
  }

  void stop_or_resume(const char* name, const char* help, Command command) {
    CLI::App* const sub = add(app_, name, help, command);
    CLI::Option* const robot = sub->add_option("ROBOT", into_.robot);
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
    add(*map, "draw", "Draw the network", Command::map_draw)
        ->add_option("OUT", into_.file, "*.png or *.svg")
        ->required();
    CLI::App* const label = add(*map, "label", "Name a place", Command::map_label);
    label->add_option("PLACE", into_.place, "A place's id, or here")->required();
    label->add_option("NAME", into_.name, "1 to 64 letters, digits, '_', '.', '-'")->required();
    label->add_option("--robot", into_.robot, "With here: the robot that stands there");
    label->callback([this] {
      into_.command = Command::map_label;
      const bool here = into_.place == "here";
      if (here && into_.robot.empty()) throw CLI::RequiredError("map label here: --robot ROBOT");
      if (!here && !into_.robot.empty())
        throw CLI::ValidationError("map label PLACE NAME: --robot goes with here only");
    });
    add(*map, "export", "Write the network as JSON", Command::map_export)->add_option("OUT", into_.file)->required();
  }

  void goals() {
    CLI::App* const goal = group("goal", "Goals and their lives");
    CLI::App* const send = add(*goal, "send", "Ask for a robot at a label", Command::goal_send);
    send->add_option("--to", into_.name, "LABEL")->required();
    send->add_option("--robot", into_.robot, "Which; otherwise any");
    add(*goal, "list", "All goals", Command::goal_list);
    one_goal(*goal, "show", "One goal with its history", Command::goal_show);
    one_goal(*goal, "watch", "Follow a goal to its end", Command::goal_watch);
    one_goal(*goal, "cancel", "Call a goal off", Command::goal_cancel);
    one_goal(*goal, "why", "What holds a goal (or a robot) up", Command::goal_why);
  }

  void one_goal(CLI::App& parent, const char* name, const char* help, Command command) {
    add(parent, name, help, command)->add_option("ID", into_.goal, "The id or its beginning")->required();
  }

  CLI::App& app_;
  Invocation& into_;
  bool all_ = false;
};

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
  invocation.vendor = environment.vendor.empty() ? "cyclonedds" : environment.vendor;
  invocation.servers = split(environment.server, ',');
  invocation.listen = "127.0.0.1";
  CLI::App app("weft: ask the fleet map server", "weft");
  app.require_subcommand(1);
  app.fallthrough();
  Grammar grammar(app, invocation);
  grammar.all();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& problem) {
    std::ostringstream out;
    std::ostringstream err;
    if (app.exit(problem, out, err) == 0) return NotRun{0, out.str()};
    return NotRun{2, mistake(app, problem)};
  }
  if (invocation.servers.empty()) invocation.servers.emplace_back("127.0.0.1");
  return invocation;
}

Result<std::vector<msg::AgentCommand::Point>> parse_polyline(std::string_view text, const std::string& file) {
  std::vector<msg::AgentCommand::Point> points;
  std::istringstream in{std::string(text)};
  std::size_t number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    line.erase(std::min(line.find('#'), line.size()));
    for (char& c : line) c = c == ',' ? ' ' : c;
    std::istringstream fields(line);
    msg::AgentCommand::Point point;
    std::string rest;
    if (!(fields >> std::ws) || fields.eof()) continue;
    if (!(fields >> point.x >> point.y) || (fields >> rest) || !std::isfinite(point.x) || !std::isfinite(point.y)) {
      return fail(ErrorCode::invalid,
                  file + ":" + std::to_string(number) + ": '" + line + "' is no point; write 'x y' in metres");
    }
    points.push_back(point);
  }
  if (points.size() < 2) return fail(ErrorCode::invalid, file + ": fewer than two points, nothing to drive along");
  return points;
}

}  // namespace weft::cli
