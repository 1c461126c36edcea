#include "clients/cli/grammar.hpp"

#include <CLI/CLI.hpp>

namespace weft::cli {

void Grammar::robots() {
  add(app_, "robots", "Each robot: what it does, where it is, since when it is silent", Command::robots);

  CLI::App* const teach = app_.add_subcommand("teach", "Teach ROBOT: what it sees from start to stop joins the map");
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
  CLI::App* const clear = add(*robot, "clear", "Free what ROBOT occupies: only when it has been taken off the floor",
                              Command::robot_clear);
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

void Grammar::stop_or_resume(const char* name, const char* help, Command command) {
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

}  // namespace weft::cli
