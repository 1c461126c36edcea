#include "clients/evaluate/invocation.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <sstream>
#include <utility>
#include <vector>

#include "core/text.hpp"

namespace weft::evaluate {
namespace {

constexpr std::uint64_t kMostSeeds = 10'000;

bool number_from(std::string_view text, std::uint64_t& into) {
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), into);
  return problem == std::errc() && end == text.data() + text.size();
}

/// One line. CLI11 misses a subcommand before it looks at what stood in its place, which is what helps most.
NotRun mistake(const CLI::App& app, const std::string& what) {
  const std::vector<std::string> strays = app.remaining(true);
  std::string words = what;
  if (!strays.empty() && words.find(strays.front()) == std::string::npos) {
    words = "'" + strays.front() + "' is not understood here (" + words + ")";
  }
  return {2, "weft-evaluate: " + one_line(words) + "; see weft-evaluate --help\n"};
}

/// How a subcommand's flags are added.
auto flags_of(CLI::App* sub) {
  return [sub](const char* flag, auto& into, const char* unit, const std::string& help) {
    return sub->add_option(flag, into, help)->type_name(unit);
  };
}

CLI::App* describe(CLI::App& app, DisturbancesOptions& options, std::string& seeds) {
  CLI::App* const sub = app.add_subcommand(
      "disturbances",
      "What each disturbance of the simulated body costs the method floor in accuracy: one robot is led along a "
      "line, "
      "another looks for its places a day later, under the site's disturbances, none, all but one, and one alone.\n"
      "Writes disturbances.csv, .json and .png. Ctrl-C stops it; the same command goes on where it stopped.");
  seeds = "1..3";
  options.site = "deploy/sites/demo.toml";
  options.out = "out/disturbances";
  const auto option = flags_of(sub);
  option("--seeds", seeds, "A..B", "Seeds A to B, or one: each is another wear, calibration and noise [1..3]");
  option("--site", options.site, "FILE",
         "Site file: the floor, the robot (its first one), how large each disturbance is [deploy/sites/demo.toml]");
  option("--along", options.along, "FILE",
         "Line to be led along, 'x y' a row in metres [r1.line in the folder named like the site, beside it]");
  option("--metres", options.metres, "M", "How much of the line, 11 to 1000 [12]")
      ->check(CLI::Range(11.0, 1000.0).description(""));
  option("--out", options.out, "DIR",
         "Folder for the results; rows that it holds already are kept [out/disturbances]");
  return sub;
}

/// What every study of floors in simulation understands.
std::vector<CLI::Option*> flags_of_floors(CLI::App* sub, FloorOptions& options, const std::string& kept_seeds,
                                          std::string& seeds) {
  options.site = "deploy/sites/demo.toml";
  seeds = kept_seeds;
  const auto option = flags_of(sub);
  return {option("--kind", options.kind, "K", "One kind of floor, or one photograph [all]"),
          option("--light", options.light, "L", "One light or wear on the other day; 'same' is none [all]"),
          option("--floors", options.floors, "DIR",
                 "Photographs of floors (docs/simulation.md) instead of the simulation's"),
          option("--seeds", seeds, "A..B",
                 "Seeds A to B, or one: each is another patch of floor, wear, calibration and noise [" + seeds + "]"),
          option("--site", options.site, "FILE",
                 "Site file: where is driven, how large the disturbances are, the robot (its first one) "
                 "[deploy/sites/demo.toml]")};
}

/// Of those that drive along a line of the site.
std::vector<CLI::Option*> flags_of_line(CLI::App* sub, FloorOptions& options) {
  const auto option = flags_of(sub);
  return {option("--along", options.along, "FILE",
                 "Line to be taught, 'x y' a row in metres [r1.line in the folder named like the site, beside it]"),
          option("--metres", options.metres, "M", "How much of the line, 5 to 1000 [26]")
              ->check(CLI::Range(5.0, 1000.0).description(""))};
}

/// The study in simulation, or a recording replayed.
struct FloorWords {
  FloorOptions study;
  std::string seeds;
  ReplayOptions replay;
  std::vector<double> mount;
  std::filesystem::path out = "out/floor";
};

/// What only one of the two understands is refused with the other.
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
  std::vector<CLI::Option*> of_study = flags_of_floors(sub, options, "1..10", words.seeds);
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
      "Writes odometry.csv and prints a table. Ctrl-C stops it; it begins anew.");
  options.out = "out/odometry";
  flags_of_floors(sub, options, "1..3", seeds);
  flags_of_line(sub, options);
  const auto option = flags_of(sub);
  option("--out", options.out, "DIR", "Folder for odometry.csv [out/odometry]");
  sub->add_flag("--candidates", options.candidates,
                "Other ways to see motion beside it (tracks, direct alignment, binary features), on the first 8 m");
  return sub;
}

CLI::App* describe(CLI::App& app, GenerateOptions& generate) {
  CLI::App* const sub = app.add_subcommand(
      "generate-site",
      "A store with a large site that many robots have driven in, to see how what is built for one bears it.\n"
      "Prints progress. Ctrl-C stops it; the same command goes on where it stopped.");
  generate.out = "out/site";
  const auto option = flags_of(sub);
  option("--places", generate.plan.places, "N", "How many places, 1 to 10000000 [10000]");
  option("--seed", generate.plan.seed, "N", "Another seed is another site [1]");
  option("--content-bytes", generate.plan.content_bytes, "N", "Content of each place, 8 to 1000000 [64]");
  option("--out", generate.out, "DIR", "The store's directory [out/site]");
  return sub;
}

template <class Options>
Parsed with_seeds(const CLI::App& app, Options options, const std::string& seeds) {
  const Result<Seeds> range = parse_seeds(seeds);
  if (!range) return mistake(app, range.error().message);
  options.seeds = *range;
  return options;
}

Parsed parsed_floor(const CLI::App& app, FloorWords words) {
  words.study.out = words.replay.out = words.out;
  if (words.replay.recording.empty()) return with_seeds(app, std::move(words.study), words.seeds);
  if (!words.mount.empty()) {
    words.replay.mount = ReplayMount{words.mount[0], words.mount[1], words.mount[2], words.mount[3]};
  }
  return words.replay;
}

}  // namespace

Result<Seeds> parse_seeds(std::string_view text) {
  const std::size_t dots = text.find("..");
  Seeds seeds;
  const bool good = dots == std::string_view::npos ? number_from(text, seeds.first) && number_from(text, seeds.last)
                                                   : number_from(text.substr(0, dots), seeds.first) &&
                                                         number_from(text.substr(dots + 2), seeds.last);
  if (!good) return fail(ErrorCode::invalid, "--seeds: '" + std::string(text) + "' is neither A..B nor one number");
  if (seeds.last < seeds.first || seeds.last - seeds.first >= kMostSeeds) {
    return fail(ErrorCode::invalid, "--seeds: '" + std::string(text) + "' is not between 1 and " +
                                        std::to_string(kMostSeeds) + " seeds, the lower number first");
  }
  return seeds;
}

Parsed parse(int argc, const char* const* argv) {
  CLI::App app("Studies of how well robots see and drive, each with a table, its data and pictures.",
               "weft-evaluate");
  app.set_version_flag("--version", "weft-evaluate " WEFT_VERSION);
  app.require_subcommand(1);
  DisturbancesOptions disturbances;
  FloorWords floor;
  AttemptsOptions attempts;
  std::string attempts_seeds;
  RelocaliseOptions relocalise;
  std::string relocalise_seeds;
  ForetoldOptions foretold;
  OdometryOptions odometry;
  GenerateOptions generate;
  std::string disturbances_seeds;
  std::string foretold_seeds;
  std::string odometry_seeds;
  const CLI::App* const disturbances_sub = describe(app, disturbances, disturbances_seeds);
  const CLI::App* const floor_sub = describe(app, floor);
  const CLI::App* const attempts_sub = describe(app, attempts, attempts_seeds);
  const CLI::App* const relocalise_sub = describe(app, relocalise, relocalise_seeds);
  const CLI::App* const foretold_sub = describe(app, foretold, foretold_seeds);
  const CLI::App* const odometry_sub = describe(app, odometry, odometry_seeds);
  describe(app, generate);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& problem) {
    std::ostringstream out;
    std::ostringstream err;
    if (app.exit(problem, out, err) == 0) return NotRun{0, out.str()};
    return mistake(app, problem.what());
  }
  if (disturbances_sub->parsed()) return with_seeds(app, disturbances, disturbances_seeds);
  if (odometry_sub->parsed()) return with_seeds(app, odometry, odometry_seeds);
  if (floor_sub->parsed()) return parsed_floor(app, floor);
  if (attempts_sub->parsed()) return with_seeds(app, attempts, attempts_seeds);
  if (relocalise_sub->parsed()) return with_seeds(app, relocalise, relocalise_seeds);
  if (foretold_sub->parsed()) return with_seeds(app, foretold, foretold_seeds);
  if (const Result<void> good = check(generate.plan); !good) return mistake(app, good.error().message);
  return generate;
}

}  // namespace weft::evaluate
