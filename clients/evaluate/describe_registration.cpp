#include <string>

#include "clients/evaluate/invocation_words.hpp"

namespace weft::evaluate {

CLI::App* describe(CLI::App& app, RegisterOptions& options) {
  CLI::App* const sub = app.add_subcommand(
      "register",
      "How two recorded clouds (PCD or PLY) lie to each other by the registration of the method topometric, beside "
      "PCL's GICP and NDT from the same guess. Ends with 1 when ours is off by more than 0.02 m or 0.4 degrees of "
      "the "
      "truth, or, where nobody knows that, by more than 0.03 m of GICP's answer.\n"
      "Prints a table.");
  const auto file = [&](const char* name, auto& into, const char* help) {
    sub->add_option(name, into, help)->required()->type_name("");
  };
  file("A", options.a, "Cloud that stays");
  file("B", options.b, "Cloud that is moved to it");
  const auto option = flags_of(sub);
  option("--truth", options.truth, "FILE", "a_from_b as a 4 x 4 matrix of numbers [nobody knows]");
  option("--guess", options.guess, "X,Y,Z,HEADING",
         "Where to begin: a_from_b in metres and radians [where they are]");
  sub->add_flag("--json", options.json, "One line of JSON instead of the table");
  return sub;
}

CLI::App* describe(CLI::App& app, RegisterRoomsOptions& options, std::string& seeds) {
  CLI::App* const sub = app.add_subcommand(
      "register-rooms",
      "Whether registering places ever harms what odometry knew of them: clouds as stereo sees rooms, aisles with "
      "relief and aisles without, edges of one run with odometry's prior, and stitches between two runs from a vague "
      "guess. Ends with 1 when a bound of row E1 does not hold.\n"
      "Prints two tables.");
  seeds = "1..20";
  flags_of(sub)(
      "--seeds", seeds, "A..B",
      "Seeds A to B, or one: each is another building, rig and noise; constants were set on 1101 to 1118 [1..20]");
  sub->add_flag("--json", options.json, "One line of JSON instead of the tables");
  return sub;
}

}  // namespace weft::evaluate
