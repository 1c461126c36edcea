#include "clients/evaluate/invocation.hpp"

#include <CLI/CLI.hpp>
#include <charconv>
#include <sstream>

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

std::variant<DisturbancesOptions, GenerateOptions, NotRun> parse(int argc, const char* const* argv) {
  CLI::App app("Studies of how well robots see and drive, each with a table, its data and a picture.",
               "weft-evaluate");
  app.set_version_flag("--version", "weft-evaluate " WEFT_VERSION);
  app.require_subcommand(1);
  CLI::App* const sub = app.add_subcommand(
      "disturbances",
      "What each disturbance of the simulated body costs the method floor in accuracy: one robot is led along a "
      "line, "
      "another looks for its places a day later, under the site's disturbances, none, all but one, and one alone.\n"
      "Writes disturbances.csv, .json and .png. Ctrl-C stops it; the same command goes on where it stopped.");
  std::string seeds = "1..3";
  DisturbancesOptions options;
  options.site = "deploy/sites/demo.toml";
  options.out = "out/disturbances";
  const auto option = [sub](const char* flag, auto& into, const char* unit, const char* help) {
    return sub->add_option(flag, into, help)->type_name(unit);
  };
  option("--seeds", seeds, "A..B", "Seeds A to B, or one: each is another wear, calibration and noise [1..3]");
  option("--site", options.site, "FILE",
         "Site file: the floor, the robot (its first one), how large each disturbance is [deploy/sites/demo.toml]");
  option("--along", options.along, "FILE",
         "Line to be led along, 'x y' a row in metres [r1.line in the folder named like the site, beside it]");
  option("--metres", options.metres, "M", "How much of the line, 11 to 1000 [12]")
      ->check(CLI::Range(11.0, 1000.0).description(""));
  option("--out", options.out, "DIR",
         "Folder for the results; rows that it holds already are kept [out/disturbances]");
  CLI::App* const site = app.add_subcommand(
      "generate-site",
      "A store with a large site that many robots have driven in, to see how what is built for one bears it.\n"
      "Prints progress. Ctrl-C stops it; the same command goes on where it stopped.");
  GenerateOptions generate;
  generate.out = "out/site";
  const auto site_option = [site](const char* flag, auto& into, const char* unit, const char* help) {
    site->add_option(flag, into, help)->type_name(unit);
  };
  site_option("--places", generate.plan.places, "N", "How many places, 1 to 10000000 [10000]");
  site_option("--seed", generate.plan.seed, "N", "Another seed is another site [1]");
  site_option("--content-bytes", generate.plan.content_bytes, "N", "Content of each place, 8 to 1000000 [64]");
  site_option("--out", generate.out, "DIR", "The store's directory [out/site]");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& problem) {
    std::ostringstream out;
    std::ostringstream err;
    if (app.exit(problem, out, err) == 0) return NotRun{0, out.str()};
    return mistake(app, problem.what());
  }
  if (site->parsed()) {
    if (const Result<void> good = check(generate.plan); !good) return mistake(app, good.error().message);
    return generate;
  }
  const Result<Seeds> range = parse_seeds(seeds);
  if (!range) return mistake(app, range.error().message);
  options.seeds = *range;
  return options;
}

}  // namespace weft::evaluate
