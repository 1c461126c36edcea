#include <CLI/CLI.hpp>

#include "clients/cli/grammar.hpp"

namespace weft::cli {

void Grammar::watching() {
  CLI::App* const events = add(app_, "events", "What has happened in the fleet, one event a line", Command::events);
  events->add_flag("--follow,-f", into_.follows, "Go on with what happens, until interrupted (Ctrl-C: ends with 0)");
  events->add_option("--robot", into_.robot, "Only of this one")->type_name("ROBOT");
  events->add_option("--kind", into_.event_kind, "Only of this kind, or of all that it begins: goal.assigned, robot")
      ->type_name("KIND");
  CLI::Option* const since =
      events
          ->add_option_function<std::string>(
              "--since",
              [this](const std::string& text) {
                const Result<Since> read = parse_since(text);
                if (!read) throw CLI::ValidationError("--since: " + read.error().message);
                into_.since = *read;
              },
              "All since then: 90s, 10min, 2h, 1d ago, or a time in UTC (2026-03-01T09:30:05Z)")
          ->type_name("WHEN");
  events->add_option("--last", into_.last, "The last so many, 1 to 1000 [100]")
      ->type_name("N")
      ->check(CLI::Range(1U, 1000U).description(""))
      ->excludes(since);
  add(app_, "alarms", "What is wrong now, with cause and cure; ends with 1 if anything is", Command::alarms);
  CLI::App* const bundle =
      add(app_, "bundle",
          "One archive for a bug report: what doctor, robots, events, alarms, goals and map say, settings without "
          "secrets, and this machine's logs",
          Command::bundle);
  bundle->add_option("OUT", into_.file, "The archive to write, *.tar.gz; it must not be there yet")
      ->required()
      ->type_name("");
  bundle->add_option("--log", into_.logs, "A log file to put in, besides this machine's journal; repeatable")
      ->allow_extra_args(false)
      ->type_name("FILE");
  bundle
      ->add_option("--settings", into_.settings, "A configuration to put in, besides those in /etc/weft; repeatable")
      ->allow_extra_args(false)
      ->type_name("FILE");
}

}  // namespace weft::cli
