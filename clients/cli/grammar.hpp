#pragma once
#include <string>

#include "clients/cli/invocation.hpp"

namespace CLI {  // NOLINT(readability-identifier-naming): the library's name
class App;
class Option;
}  // namespace CLI

namespace weft::cli {

/// Builds the commands; each sets its fields of `into` when it is the one.
class Grammar {
 public:
  Grammar(CLI::App& app, Invocation& into) : app_(app), into_(into) {}

  /// Adds every command.
  void all();

 private:
  using Command = Invocation::Command;

  /// Returns help for a name: what it is for, and which names are good.
  static std::string rule(const std::string& what);
  CLI::App* group(const char* name, const char* help);
  CLI::App* add(CLI::App& parent, const char* name, const char* help, Command command);
  void globals();
  void doctor();
  void files();
  void goals();
  void one_goal(CLI::App& parent, const char* name, const char* help, Command command,
                const char* id = "The goal's id or its beginning");

  // grammar_robots.cpp
  void robots();
  void stop_or_resume(const char* name, const char* help, Command command);

  // grammar_map.cpp
  void map();
  /// Lets a drawing be a mosaic, which goes neither with a floor plan below it nor with robots.
  void mosaic(CLI::App& draw, CLI::Option& ground, CLI::Option& robots);
  void past(CLI::App& map);
  static CLI::Option* revision(CLI::App& sub, const char* name, Revision& into, const char* help);
  void anchors(CLI::App& sub);
  CLI::Option* anchor_option(CLI::App& sub, const char* name, const char* help);

  // grammar_register.cpp
  void registering(CLI::App& map);
  /// Lets a goal be a point of a registered floor plan.
  void to_plan(CLI::App& send);

  // grammar_map_work.cpp
  /// Adds the commands that edit the map. Each makes one revision, which `map undo --revision` takes back.
  void edits(CLI::App& map);
  void apart(CLI::App& map);
  void upkeep(CLI::App& map);
  CLI::Option* what_option(CLI::App& sub);
  void only_say(CLI::App& sub);
  void covering(CLI::App& sub);

  // grammar_watch.cpp
  /// Adds what looks at the whole fleet: events, alarms, and the archive for a bug report.
  void watching();

  // grammar_rules.cpp
  /// Adds the commands on rules. Each change is one revision, which `map undo --revision` takes back.
  void rules();
  void refreshing(CLI::App& parent);
  void one_edge(CLI::App& parent, const char* name, const char* help, Command command);
  void held(CLI::App& parent, const char* name, const char* help, Command command);
  /// Reads "KIND" or "KIND=VALUE".
  void read_kind(const std::string& text);

  CLI::App& app_;
  Invocation& into_;
  bool all_ = false;
  bool apply_ = false;
  bool fleet_ = false;
};

}  // namespace weft::cli
