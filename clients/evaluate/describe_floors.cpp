#include <cstddef>
#include <string>
#include <vector>

#include "clients/evaluate/invocation_words.hpp"

namespace weft::evaluate {
namespace {

/// Adds the flags that every study of floors in simulation understands.
std::vector<CLI::Option*> flags_of_floors(CLI::App* sub, FloorOptions& options, const std::string& kept_seeds,
                                          std::string& seeds) {
  options.site = "deploy/sites/demo.toml";
  seeds = kept_seeds;
  const auto option = flags_of(sub);
  return {option("--kind", options.kind, "K", "One kind of floor, or one photograph [all]"),
          option("--light", options.light, "L",
                 "One light or wear on the other day; 'same' is none [all; floor: same, halved, dirt]"),
          option("--floors", options.floors, "DIR",
                 "Photographs of floors (docs/simulation.md) instead of the simulation's"),
          option("--seeds", seeds, "A..B",
                 "Seeds A to B, or one: each is another patch of floor, wear, calibration and noise [" + seeds + "]"),
          option("--site", options.site, "FILE",
                 "Site file: where is driven, how large the disturbances are, the robot (its first one) "
                 "[deploy/sites/demo.toml]")};
}

/// Adds the flags of those studies that drive along a line of the site.
std::vector<CLI::Option*> flags_of_line(CLI::App* sub, FloorOptions& options) {
  const auto option = flags_of(sub);
  return {option("--along", options.along, "FILE",
                 "Line to be taught, 'x y' a row in metres [r1.line in the folder named like the site, beside it]"),
          option("--metres", options.metres, "M", "How much of the line, 5 to 1000 [26]")
              ->check(CLI::Range(5.0, 1000.0).description(""))};
}

}  // namespace

/// Adds `floor`, a study or a replay; flags that only one of the two understands are refused with the other.
CLI::App* describe(CLI::App& app, FloorWords& words) {
  CLI::App* const sub = app.add_subcommand(
      "floor",
      "How well robots navigate by floors (method floor), against what is promised of it: one robot is led along a "
      "line and taught it, another one repeats it by itself on another day, on every kind of floor and under every "
      "light and wear.\n"
      "Writes floor.csv, floor.json, ten pictures and series/ (docs/floor-study.md). Ctrl-C stops it; the same "
      "command "
      "goes on where it stopped.\n"
      "With --replay: odometry, mapping and localisation on a recording instead. Writes replay.json and replay.png.");
  FloorOptions& options = words.study;
  const auto option = flags_of(sub);
  std::vector<CLI::Option*> of_study = flags_of_floors(sub, options, "1..4", words.seeds);
  options.usual_lights = {"same", "halved", "dirt"};
  CLI::Option* const whole =
      sub->add_flag("--all", words.is_whole, "Under every light and kind of wear, seeds 1..10: hours");
  of_study.push_back(whole);
  of_study.push_back(sub->add_flag("--quick", words.is_quick,
                                   "Epoxy, nothing changed, seed 1, 6 m: says within three minutes that it works")
                         ->excludes(whole));
  for (CLI::Option* const flag : flags_of_line(sub, options)) of_study.push_back(flag);
  CLI::Option* const replay =
      option("--replay", words.replay.recording, "DIR", "A recording in EuRoC layout (mav0/cam0), floor in view");
  for (CLI::Option* const flag : of_study) flag->excludes(replay);
  option("--query", words.replay.query, "DIR", "Replay: a recording to localise in the first [the first once more]")
      ->needs(replay);
  option("--truth", words.replay.truth, "FILE",
         "Replay: trajectory, TUM or (.csv) EuRoC [groundtruth_tum.txt, groundtruth.txt or "
         "mav0/state_groundtruth_estimate0/data.csv of the recording]")
      ->needs(replay);
  option("--camera", words.replay.camera, "NAME", "Replay: which camera [cam0]")->needs(replay);
  option(
      "--mount", words.mount, "X,Y,Z,DEG",
      "Replay: camera so far in front of and left of the robot's middle and above the floor, metres, looking so far "
      "down from level [the recording's own]")
      ->delimiter(',')
      ->expected(4)
      ->needs(replay);
  option("--out", words.out, "DIR", "Folder for the results; rows that it holds already are kept [out/floor]");
  return sub;
}

CLI::App* describe(CLI::App& app, AttemptsOptions& options, std::string& seeds) {
  CLI::App* const sub = app.add_subcommand(
      "floor-attempts",
      "How often the method floor gives a wrong place: views of another robot on another day related with taught "
      "places as such, and as navigation does it. More than half of the attempts have no right answer, or another "
      "place looks alike. Ends with 1 when one was wrong.\n"
      "Writes attempts.csv, attempts.json and floor-attempts.png (docs/floor-study.md). Ctrl-C stops it; the same "
      "command goes on where it stopped.");
  options.out = "out/floor-attempts";
  flags_of_floors(sub, options, "1..2", seeds);
  flags_of_line(sub, options);
  const auto option = flags_of(sub);
  option("--attempts", options.attempts, "N", "How many, of all floors, lights and seeds together [100000]")
      ->check(CLI::Range(std::size_t{1}, std::size_t{100'000'000}).description(""));
  option("--out", options.out, "DIR",
         "Folder for the results; rows that it holds already are kept [out/floor-attempts]");
  return sub;
}

CLI::App* describe(CLI::App& app, RelocaliseOptions& options, std::string& seeds) {
  CLI::App* const sub = app.add_subcommand("floor-relocalise",
                                           "How far a robot that knows nothing of where it is has to be pushed until "
                                           "it knows (method floor): a network is "
                                           "taught in a hall with room for it, and another robot is put down in it "
                                           "on another day, headed either way. Ends "
                                           "with 1 when it ever believed a wrong place.\n"
                                           "Writes relocalise.csv, relocalise.json and floor-relocalise.png "
                                           "(docs/floor-study.md). Ctrl-C stops it; the same "
                                           "command goes on where it stopped.");
  options.out = "out/floor-relocalise";
  options.metres = 1000.0;
  flags_of_floors(sub, options, "1..3", seeds);
  const auto option = flags_of(sub);
  option("--metres", options.metres, "M", "How long the network is, 10 to 20000 [1000]")
      ->check(CLI::Range(10.0, 20000.0).description(""));
  option("--trials", options.trials, "N", "How many, of each floor, light and seed [1000]")
      ->check(CLI::Range(std::size_t{1}, std::size_t{1'000'000}).description(""));
  option("--out", options.out, "DIR",
         "Folder for the results; trials that it holds already are kept [out/floor-relocalise]");
  return sub;
}

CLI::App* describe(CLI::App& app, ForetoldOptions& options, std::string& seeds) {
  CLI::App* const sub = app.add_subcommand(
      "foretold",
      "Whether teaching foretells how places will be found again: one robot is taught a line, and what it foretells "
      "(`weft teach ROBOT report`) is held against what another one finds on another day, as it is, in half the "
      "light "
      "and with dirt on the floor.\n"
      "Prints a table and writes it, foretold.md.");
  options.out = "out/foretold";
  flags_of_floors(sub, options, "1..3", seeds);
  flags_of_line(sub, options);
  const auto option = flags_of(sub);
  option("--contrast", options.contrast, "X", "How strong the floors' contrast is, 0.01 to 4 [1]")
      ->check(CLI::Range(0.01, 4.0).description(""));
  option("--out", options.out, "DIR", "Folder for the table [out/foretold]");
  return sub;
}

CLI::App* describe(CLI::App& app, OdometryOptions& options, std::string& seeds) {
  CLI::App* const sub = app.add_subcommand(
      "odometry",
      "How good the odometry of the method floor is by itself: each drive is watched with the camera as it was "
      "calibrated and as it is given, at three frame rates; speed error, drift, and how often the 95 % region of its "
      "covariance holds the truth over 1 m and 10 m.\n"
      "Writes odometry.json and odometry.csv, prints a table and what holds. Ctrl-C stops it; the same command goes "
      "on where it stopped.");
  options.out = "out/odometry";
  flags_of_floors(sub, options, "1..3", seeds);
  flags_of_line(sub, options);
  const auto option = flags_of(sub);
  option("--out", options.out, "DIR", "Folder for the results; rows that it holds already are kept [out/odometry]");
  auto* const candidates = sub->add_flag(
      "--candidates", options.candidates,
      "Other ways to see motion beside it (tracks, direct alignment, binary features), on the first 8 m");
  sub->add_flag("--regions", options.regions,
                "Only what the 95 % regions are judged by, of 40 seeds or more: the drive at the site's frame rate")
      ->excludes(candidates);
  return sub;
}

}  // namespace weft::evaluate
