#include "clients/evaluate/invocation_words.hpp"

namespace weft::evaluate {

CLI::App* describe(CLI::App& app, ParticlesOptions& options, std::string& seeds) {
  CLI::App* const sub = app.add_subcommand(
      "particles",
      "How well the particle filter locates a recorded laser: scans with even numbers make a grid, those with odd "
      "ones "
      "are located in it, with odometry made of the log's poses and errors (docs/results/particles.md). Ends with 1 "
      "when a seed is lost or something that is asked of the log does not hold.\n"
      "Writes particles.csv, .json and .png. Ctrl-C stops it; the same command goes on where it stopped.");
  seeds = "1..3";
  const auto option = flags_of(sub);
  sub->add_option("LOG", options.log, "CARMEN log with corrected poses (FLASER lines), packed by gzip or not")
      ->required()
      ->type_name("");
  option("--seeds", seeds, "A..B",
         "Seeds A to B, or one: each is other errors of odometry and other particles [1..3]");
  option("--alpha", options.alpha, "A", "All four alphas of AMCL's motion model, (0, 4] [0.2, as nav2 has it]")
      ->check(CLI::Range(1e-6, 4.0).description(""));
  sub->add_flag("--global", options.is_anywhere,
                "Begin anywhere, with 10000 particles, and count the updates until it has found itself");
  option("--out", options.out, "DIR",
         "Folder for the results, one for each log; rows that it holds already are kept [out/particles/LOG]");
  sub->add_flag("--json", options.json, "One line of JSON instead of the table");
  return sub;
}

}  // namespace weft::evaluate
