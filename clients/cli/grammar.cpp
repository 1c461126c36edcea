#include "clients/cli/grammar.hpp"

#include <CLI/CLI.hpp>

#include "core/names.hpp"

namespace weft::cli {

std::string Grammar::rule(const std::string& what) {
  return what + ": " + std::string(kNameRule);
}

void Grammar::all() {
  globals();
  robots();
  map();
  goals();
  rules();
  files();
  add(app_, "calibrate",
      "Find out a robot's camera, or how it is mounted: `weft calibrate --help`; needs no server but weft-agent",
      Command::calibrate);
  doctor();
  watching();
  // Last, because commands inherit the footer that is there when they are added.
  app_.footer(
      "ROBOT is a robot's name or id. Each command has its own --help. An example, in order:\n"
      "  weft robots; weft teach r1 start --as loop; weft map label here --robot r1 dock; weft teach r1 stop;\n"
      "  weft goal send --to dock; weft goal list; weft goal watch ID; weft map draw map.svg\n"
      "Exit codes: 0 done, 1 failed, 2 wrong usage, 3 no server reached, 4 refused, 5 no answer in time");
}

void Grammar::doctor() {
  CLI::App* const all =
      add(app_, "doctor", "Look for what is wrong: server, vendors, versions, clocks, disk", Command::doctor);
  all->add_flag("--fleet", fleet_, "Instead: each robot's clock, disk, link, version and method, a line each");
  CLI::App* const network =
      add(*all, "network", "Measure loss, delay and throughput to the server, for 17 s and at 0.5 MB/s at most",
          Command::doctor_network);
  // Takes the place of the callbacks that add() gave: the one of the command above runs last.
  all->callback([this, network] {
    if (fleet_ && network->parsed()) throw CLI::ExcludesError("--fleet", "network");
    into_.command = network->parsed() ? Command::doctor_network : fleet_ ? Command::doctor_fleet : Command::doctor;
  });
}

CLI::App* Grammar::group(const char* name, const char* help) {
  CLI::App* const group = app_.add_subcommand(name, help);
  group->require_subcommand(1);
  return group;
}

CLI::App* Grammar::add(CLI::App& parent, const char* name, const char* help, Command command) {
  CLI::App* const sub = parent.add_subcommand(name, help);
  sub->add_flag("--json", into_.json, "Print one JSON document");
  sub->callback([this, command] { into_.command = command; });
  return sub;
}

void Grammar::globals() {
  app_.add_option("--server", into_.servers, "Where weft-server listens; repeatable [WEFT_SERVER, or 127.0.0.1]")
      ->type_name("HOST[:INDEX]");
  app_.add_option("--dds", into_.vendor, "fastdds | cyclonedds; any goes with any server [WEFT_DDS, or cyclonedds]")
      ->type_name("VENDOR")
      ->check(CLI::IsMember({"fastdds", "cyclonedds"}).description(""));
  app_.add_option("--domain", into_.domain, "The server's DDS domain, 0 to 200 [WEFT_DOMAIN, or 0]")
      ->type_name("N")
      ->check(CLI::Range(0U, 200U).description(""));
  app_.add_option("--listen", into_.listen,
                  "Own address or interface, on the network of the server [WEFT_LISTEN, or 127.0.0.1]")
      ->type_name("HOST");
  app_.add_option("--timeout", into_.timeout_s, "Seconds to wait for an answer, 0.1 to 86400 [as suits the command]")
      ->type_name("S")
      ->check(CLI::Range(0.1, 86400.0).description(""));
  app_.add_flag("--json", into_.json, "Print one JSON document");
}

void Grammar::files() {
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
  convert
      ->add_option("--voxel", into_.thinning.voxel_m,
                   "Of a cloud: one point for each cube of this edge, without colours, intensities and normals")
      ->type_name("M")
      ->check(CLI::Range(0.001, 1000.0).description(""));
  convert
      ->add_option("--alone", into_.thinning.alone_m,
                   "Of a cloud: leave out points with fewer than 3 others this near")
      ->type_name("M")
      ->check(CLI::Range(0.001, 1000.0).description(""));
}

void Grammar::goals() {
  CLI::App* const goal = group("goal", "Goals and their lives");
  CLI::App* const send = add(*goal, "send", "Send a robot to a label; prints the goal's id", Command::goal_send);
  send->add_option("--to", into_.name, "Where: a label of the map")->type_name("LABEL");
  to_plan(*send);
  send->add_option("--robot", into_.robot, "Which; otherwise the idle one with the shortest way")->type_name("ROBOT");
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

void Grammar::one_goal(CLI::App& parent, const char* name, const char* help, Command command, const char* id) {
  add(parent, name, help, command)->add_option("ID", into_.goal, id)->type_name("")->required();
}

}  // namespace weft::cli
