#include "clients/cli/grammar.hpp"

#include <CLI/CLI.hpp>

namespace weft::cli {

void Grammar::edits(CLI::App& map) {
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

void Grammar::apart(CLI::App& map) {
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

void Grammar::upkeep(CLI::App& map) {
  add(map, "check", "Read all that is stored, checksums and references, and name what is damaged",
      Command::map_check);
  add(map, "stats", "What takes space in the store", Command::map_stats);
  CLI::App* const snapshot =
      add(map, "snapshot", "Copy the store into a file on the server's machine while it runs", Command::map_snapshot);
  snapshot->add_option("FILE", into_.file, "An absolute path there; it must not exist")->required()->type_name("");
  snapshot->add_flag("--verify", into_.verifies,
                     "Then restore it into FILE.verifying, check all of it, compare it with the map, and remove that "
                     "folder; needs the room of a second snapshot beside FILE");
  CLI::App* const compact =
      add(map, "compact", "Delete for good what no revision from R on has; there is no way back before R",
          Command::map_compact);
  revision(*compact, "--before", into_.to, "The oldest revision to keep")->required()->type_name("R");
  CLI::App* const restore = add(
      map, "restore", "Make a snapshot the map of a server that does not run; needs no server", Command::map_restore);
  restore->add_option("FILE", into_.file, "As `weft map snapshot` wrote it")->required()->type_name("");
  restore->add_option("--store", into_.store, "The server's --store; what was there is kept aside")
      ->required()
      ->type_name("DIR");
  restore->add_flag("--accept-damage", into_.accept_damage, "Of a damaged snapshot, restore what is sound");
}

CLI::Option* Grammar::what_option(CLI::App& sub) {
  return sub
      .add_option("WHAT", into_.what,
                  "A stitch E:I-F:J, a place E:I, places E:I..J (E, F: 16 hex digits), or an experience's "
                  "name or id")
      ->type_name("");
}

void Grammar::only_say(CLI::App& sub) {
  sub.add_flag("--dry-run", into_.only_say, "Say what it would do, and change nothing");
}

void Grammar::covering(CLI::App& sub) {
  sub.add_option("--within", into_.within_m, "How near a place covers another, metres [0.5]")
      ->type_name("M")
      ->check(CLI::Range(0.01, 10.0).description(""));
  sub.add_option("--within-deg", into_.within_deg, "And how alike they look, degrees [20]")
      ->type_name("DEG")
      ->check(CLI::Range(0.1, 180.0).description(""));
}

}  // namespace weft::cli
