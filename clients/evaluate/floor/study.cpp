#include "clients/evaluate/floor/study.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "agents/bodies/sim/changes.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/floor/bounds.hpp"
#include "clients/evaluate/floor/figure_runs.hpp"
#include "clients/evaluate/floor/figures.hpp"
#include "clients/evaluate/floor/measurement.hpp"
#include "clients/evaluate/floor/rows.hpp"
#include "clients/evaluate/floor/scenario.hpp"
#include "clients/evaluate/line.hpp"

namespace weft::evaluate::floor {
namespace {

struct Subject {
  Stage stage;
  Study study;
  std::vector<std::string> kinds;
  std::vector<std::string> lights;
};

/// One of the names, or all of them. invalid: names those there are.
Result<std::vector<std::string>> chosen(const std::vector<std::string>& names, const std::string& one,
                                        const std::string& flag) {
  if (one.empty()) return names;
  if (std::find(names.begin(), names.end(), one) != names.end()) return std::vector{one};
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return fail(ErrorCode::invalid, flag + ": there is no '" + one + "'; there are " + list);
}

/// What is in a folder of photographs, by name and size.
std::string print_of(const std::filesystem::path& folder) {
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.is_regular_file())
      files.push_back(entry.path().filename().string() + " " + std::to_string(entry.file_size()));
  }
  std::sort(files.begin(), files.end());
  std::string all;
  for (const std::string& file : files) all += file + "\n";
  return sha256_of(all);
}

/// The floors to study. invalid: there is no such kind; not_found: no photographs.
Result<std::vector<std::string>> kinds_of(const FloorOptions& options, Subject& subject) {
  if (!options.floors.empty()) {
    const Result<std::vector<std::string>> photographs = photographs_in(options.floors);
    if (!photographs) return fail(photographs.error());
    subject.stage.floors_dir = options.floors.string();
    subject.study.floors_sha256 = print_of(options.floors);
    return chosen(*photographs, options.kind, "--kind");
  }
  if (options.kind.empty()) return agents::sim::floor_kinds();
  // Any material will do, those too that are no kind of their own.
  if (const auto laid = agents::sim::on_floor(subject.stage.site, options.kind); !laid) {
    return fail(laid.error().code, "--kind: " + laid.error().message);
  }
  return std::vector{options.kind};
}

Result<Subject> subject_of(const FloorOptions& options, const Surroundings& around) {
  const Result<std::string> site_text = read_text(options.site, "site file; deploy/sites has some");
  if (!site_text) return fail(site_text.error());
  Result<agents::sim::Site> site = agents::sim::parse_site(*site_text, options.site.string());
  if (!site) return fail(site.error());
  const std::filesystem::path along =
      options.along.empty() ? options.site.parent_path() / options.site.stem() / "r1.line" : options.along;
  const Result<std::string> line_text = read_text(along, "line to drive along; give one with --along");
  if (!line_text) return fail(line_text.error());
  const Result<std::vector<agents::SitePoint>> line = parse_line(*line_text, along.string());
  if (!line) return fail(line.error());
  Result<std::vector<agents::SitePoint>> part = first_metres(*line, options.metres, along.string());
  if (!part) return fail(part.error());
  Subject subject;
  subject.stage = {std::move(*site), std::move(*part), std::nullopt, options.out / "truth.now", around.asked_to_stop};
  subject.study = {WEFT_VERSION, sha256_of(*site_text), sha256_of(*line_text), "", options.metres};
  Result<std::vector<std::string>> kinds = kinds_of(options, subject);
  if (!kinds) return fail(kinds.error());
  Result<std::vector<std::string>> some_lights = chosen(lights(), options.light, "--light");
  if (!some_lights) return fail(some_lights.error());
  subject.kinds = std::move(*kinds);
  subject.lights = std::move(*some_lights);
  return subject;
}

std::vector<std::string> parts_of(const Subject& subject) {
  std::vector<std::string> parts = {kMapping};
  parts.insert(parts.end(), subject.lights.begin(), subject.lights.end());
  return parts;
}

Shelf shelf_of(const Subject& subject, const FloorOptions& options, const std::string& kind, std::uint64_t seed) {
  return {options.out / "series", stamp_of(subject.study), kind, seed};
}

/// Rows and, of the first seed, the runs that pictures show.
std::size_t kept_of(const Rows& rows, const Subject& subject, const FloorOptions& options) {
  std::size_t kept = 0;
  for (const std::string& kind : subject.kinds) {
    for (std::uint64_t seed = options.seeds.first; seed <= options.seeds.last; ++seed) {
      for (const std::string& part : parts_of(subject)) kept += rows.count({kind, part, seed});
    }
    const Shelf shelf = shelf_of(subject, options, kind, options.seeds.first);
    kept += has_shown(subject.lights.front(), shelf) ? 1 : 0;
  }
  return kept;
}

/// Seed by seed, so that what an interruption leaves is whole comparisons of the floors.
Result<Ended> measure_all(const Subject& subject, const FloorOptions& options, Rows& rows, RowsMeasured& progress,
                          const Surroundings& around) {
  for (std::uint64_t seed = options.seeds.first; seed <= options.seeds.last; ++seed) {
    for (const std::string& kind : subject.kinds) {
      const Result<Scenario> scenario = Scenario::make(subject.stage, kind, seed);
      if (!scenario) return fail(scenario.error());
      const auto keep = [&](const RowKey& key, const Score& score) {
        rows.insert_or_assign(key, score);
        progress.row(key.kind + ", " + key.part + ", seed " + std::to_string(key.seed));
        return write_rows(options.out, subject.study, rows, options.seeds);
      };
      const bool is_shown = seed == options.seeds.first;
      Measurement measurement(*scenario, shelf_of(subject, options, kind, seed), is_shown, around, keep);
      for (const std::string& part : parts_of(subject)) {
        if (rows.contains({kind, part, seed})) continue;
        const Result<Ended> ended = part == kMapping ? measurement.mapping() : measurement.repeat_under(part);
        if (!ended || *ended == Ended::stopped) return ended;
      }
    }
  }
  return Ended::complete;
}

/// What pictures show, of the first seed.
Result<Ended> show_all(const Subject& subject, const FloorOptions& options, Pictured& pictured,
                       RowsMeasured& progress) {
  const std::uint64_t seed = options.seeds.first;
  for (const std::string& kind : subject.kinds) {
    const Result<Scenario> scenario = Scenario::make(subject.stage, kind, seed);
    if (!scenario) return fail(scenario.error());
    const Shelf shelf = shelf_of(subject, options, kind, seed);
    const bool was_there = has_shown(subject.lights.front(), shelf);
    Result<std::optional<Shown>> shown = shown_of(*scenario, subject.lights.front(), shelf);
    if (!shown) return fail(shown.error());
    if (!*shown) return Ended::stopped;
    if (!was_there) progress.row(kind + ", for the pictures");
    pictured.kinds.push_back(std::move(**shown));
  }
  pictured.camera_height_m = subject.stage.site.camera.height_m;
  pictured.about = "site " + subject.stage.site.name + ", method floor, " +
                   std::to_string(std::lround(options.metres)) + " m, seed " + std::to_string(seed) +
                   ", repeated under: " + subject.lights.front();
  return Ended::complete;
}

/// Without what other calls have left in the folder.
Rows asked_for(const Rows& rows, const Subject& subject, Seeds seeds) {
  Rows some;
  for (const auto& [key, score] : rows) {
    const auto parts = parts_of(subject);
    const bool is_asked = std::find(subject.kinds.begin(), subject.kinds.end(), key.kind) != subject.kinds.end() &&
                          std::find(parts.begin(), parts.end(), key.part) != parts.end() && key.seed >= seeds.first &&
                          key.seed <= seeds.last;
    if (is_asked) some.emplace(key, score);
  }
  return some;
}

Result<Ended> report(const Subject& subject, const FloorOptions& options, const Rows& rows, const Pictured& pictured,
                     const Surroundings& around) {
  if (const Result<void> csv = write_csv(options.out, rows); !csv) return fail(csv.error());
  if (const Result<void> json = write_rows(options.out, subject.study, rows, options.seeds); !json) {
    return fail(json.error());
  }
  const Rows asked = asked_for(rows, subject, options.seeds);
  const Result<std::vector<std::string>> drawn = draw_figures(pictured, asked, options.seeds, options.out);
  if (!drawn) return fail(drawn.error());
  around.out << tables_of(asked, options.seeds) << std::flush;
  around.progress << "weft-evaluate: floor.csv, floor.json and " << drawn->size() << " pictures are in "
                  << options.out.string() << '\n';
  return Ended::complete;
}

}  // namespace

Result<Ended> study_floor(const FloorOptions& options, const Surroundings& around) {
  const Result<Subject> subject = subject_of(options, around);
  if (!subject) return fail(subject.error());
  std::error_code problem;
  std::filesystem::create_directories(options.out, problem);
  if (problem) return fail(ErrorCode::unavailable, options.out.string() + ": " + problem.message());
  Result<Rows> rows = read_rows(options.out, subject->study);
  if (!rows) return fail(rows.error());
  const std::size_t seeds = options.seeds.last - options.seeds.first + 1;
  const std::size_t all = subject->kinds.size() * (parts_of(*subject).size() * seeds + 1);
  RowsMeasured progress(all, kept_of(*rows, *subject, options), around);
  const Result<Ended> measured = measure_all(*subject, options, *rows, progress, around);
  if (!measured || *measured == Ended::stopped) return measured;
  Pictured pictured;
  const Result<Ended> shown = show_all(*subject, options, pictured, progress);
  if (!shown || *shown == Ended::stopped) return shown;
  return report(*subject, options, *rows, pictured, around);
}

}  // namespace weft::evaluate::floor
