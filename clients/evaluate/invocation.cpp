#include "clients/evaluate/invocation.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <utility>
#include <vector>

#include "clients/evaluate/invocation_words.hpp"
#include "core/text.hpp"

namespace weft::evaluate {
namespace {

constexpr std::uint64_t kMostSeeds = 10'000;

bool whole_number(std::string_view text, std::uint64_t& into) {
  const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), into);
  return problem == std::errc() && end == text.data() + text.size();
}

/// Puts a mistake into one line. CLI11 misses a subcommand before it sees what stood in its place: that helps most.
NotRun mistake(const CLI::App& app, const std::string& what) {
  const std::vector<std::string> strays = app.remaining(true);
  std::string words = what;
  if (!strays.empty() && words.find(strays.front()) == std::string::npos) {
    words = "'" + strays.front() + "' is not understood here (" + words + ")";
  }
  return {2, "weft-evaluate: " + one_line(words) + "; see weft-evaluate --help\n"};
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
  const bool has_seeds = app.get_subcommand("floor")->get_option("--seeds")->count() > 0;
  if (words.is_whole) words.study.usual_lights.clear();
  if (words.is_whole && !has_seeds) words.seeds = "1..10";
  if (words.is_quick) {
    constexpr double kQuick_m = 6.0;
    if (!has_seeds) words.seeds = "1";
    if (words.study.kind.empty()) words.study.kind = "epoxy";
    if (words.study.light.empty()) words.study.light = "same";
    words.study.metres = std::min(words.study.metres, kQuick_m);
  }
  if (words.replay.recording.empty()) return with_seeds(app, std::move(words.study), words.seeds);
  if (!words.mount.empty()) {
    words.replay.mount = ReplayMount{words.mount[0], words.mount[1], words.mount[2], words.mount[3]};
  }
  return words.replay;
}

Parsed parsed_bearing(const CLI::App& app, BearingWords words) {
  const bool has_seeds = app.get_subcommand("bearing")->get_option("--seeds")->count() > 0;
  if (words.is_quick && !has_seeds) words.seeds = "1";
  if (words.is_quick && words.study.trial.empty()) words.study.trial = "oval-behind";
  return with_seeds(app, std::move(words.study), words.seeds);
}

Parsed parsed_bearing_relocalise(const CLI::App& app, BearingRelocaliseWords words) {
  const CLI::App* const sub = app.get_subcommand("bearing-relocalise");
  constexpr std::size_t kQuickTrials = 2;
  if (words.is_quick && sub->get_option("--seeds")->count() == 0) words.seeds = "1";
  if (words.is_quick && sub->get_option("--trials")->count() == 0) words.study.trials = kQuickTrials;
  return with_seeds(app, std::move(words.study), words.seeds);
}

Parsed parsed_ceiling(const CLI::App& app, CeilingWords words) {
  if (words.is_quick) {
    constexpr double kQuickLineM = 8.0;
    constexpr std::size_t kQuickPutDowns = 40;
    const CLI::App* const sub = app.get_subcommand("ceiling");
    if (sub->get_option("--seeds")->count() == 0) words.seeds = "1";
    if (sub->get_option("--put-downs")->count() == 0) words.study.extent.put_downs = kQuickPutDowns;
    words.study.extent.metres = std::min(words.study.extent.metres, kQuickLineM);
    words.study.extent.is_quick = true;
  }
  return with_seeds(app, std::move(words.study), words.seeds);
}

Parsed parsed_topometric(const CLI::App& app, TopometricWords words) {
  const bool has_seeds = app.get_subcommand("topometric")->get_option("--seeds")->count() > 0;
  if (words.is_quick && !has_seeds) words.seeds = "1";
  words.study.extent.is_quick = words.is_quick;
  return with_seeds(app, std::move(words.study), words.seeds);
}

Parsed parsed_particles(const CLI::App& app, ParticlesOptions options, const std::string& seeds) {
  if (options.out.empty()) {
    const std::string name = options.log.filename().string();
    options.out = std::filesystem::path("out/particles") / name.substr(0, name.find('.'));
  }
  return with_seeds(app, std::move(options), seeds);
}

StereoOptions parsed_stereo(StereoOptions options) {
  if (!options.out.empty()) return options;
  const std::filesystem::path folder = (options.folder / "x").lexically_normal().parent_path();
  options.out = std::filesystem::path("out/stereo") / folder.filename();
  return options;
}

}  // namespace

Result<Seeds> parse_seeds(std::string_view text) {
  const std::size_t dots = text.find("..");
  Seeds seeds;
  const bool good = dots == std::string_view::npos ? whole_number(text, seeds.first) && whole_number(text, seeds.last)
                                                   : whole_number(text.substr(0, dots), seeds.first) &&
                                                         whole_number(text.substr(dots + 2), seeds.last);
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
  BearingWords bearing;
  BearingRelocaliseWords look_alikes;
  LearningOptions learning;
  std::string learning_seeds;
  HeadingOptions heading;
  CeilingWords ceiling;
  CeilingFramesOptions ceiling_frames;
  RegisterOptions registered;
  RegisterRoomsOptions rooms;
  std::string rooms_seeds;
  ParticlesOptions particles;
  std::string particles_seeds;
  StereoOptions stereo;
  TopometricWords topometric;
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
  const CLI::App* const bearing_sub = describe(app, bearing);
  const CLI::App* const look_alikes_sub = describe(app, look_alikes);
  const CLI::App* const learning_sub = describe(app, learning, learning_seeds);
  const CLI::App* const heading_sub = describe(app, heading);
  const CLI::App* const ceiling_sub = describe(app, ceiling);
  const CLI::App* const ceiling_frames_sub = describe(app, ceiling_frames);
  const CLI::App* const register_sub = describe(app, registered);
  const CLI::App* const rooms_sub = describe(app, rooms, rooms_seeds);
  const CLI::App* const particles_sub = describe(app, particles, particles_seeds);
  const CLI::App* const stereo_sub = describe(app, stereo);
  const CLI::App* const topometric_sub = describe(app, topometric);
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
  if (bearing_sub->parsed()) return parsed_bearing(app, bearing);
  if (look_alikes_sub->parsed()) return parsed_bearing_relocalise(app, look_alikes);
  if (learning_sub->parsed()) return with_seeds(app, learning, learning_seeds);
  if (heading_sub->parsed()) return heading;
  if (ceiling_sub->parsed()) return parsed_ceiling(app, ceiling);
  if (ceiling_frames_sub->parsed()) return ceiling_frames;
  if (register_sub->parsed()) return registered;
  if (rooms_sub->parsed()) return with_seeds(app, rooms, rooms_seeds);
  if (particles_sub->parsed()) return parsed_particles(app, std::move(particles), particles_seeds);
  if (stereo_sub->parsed()) return parsed_stereo(std::move(stereo));
  if (topometric_sub->parsed()) return parsed_topometric(app, topometric);
  if (floor_sub->parsed()) return parsed_floor(app, floor);
  if (attempts_sub->parsed()) return with_seeds(app, attempts, attempts_seeds);
  if (relocalise_sub->parsed()) return with_seeds(app, relocalise, relocalise_seeds);
  if (foretold_sub->parsed()) return with_seeds(app, foretold, foretold_seeds);
  if (const Result<void> good = check(generate.plan); !good) return mistake(app, good.error().message);
  return generate;
}

}  // namespace weft::evaluate
