#include "clients/evaluate/floor/study.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "clients/evaluate/charts/draw.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/floor/bounds.hpp"
#include "clients/evaluate/floor/figure_runs.hpp"
#include "clients/evaluate/floor/measurement.hpp"
#include "clients/evaluate/floor/other_promises.hpp"
#include "clients/evaluate/floor/rows.hpp"
#include "clients/evaluate/floor/scenario.hpp"
#include "clients/evaluate/floor/shown.hpp"
#include "clients/evaluate/floor/subject.hpp"
#include "clients/evaluate/floor/tables.hpp"

namespace weft::evaluate::floor {
namespace {

std::vector<std::string> parts_of(const Subject& subject) {
  std::vector<std::string> parts = {kMapping};
  parts.insert(parts.end(), subject.lights.begin(), subject.lights.end());
  return parts;
}

Shelf shelf_of(const Subject& subject, const FloorOptions& options, const std::string& kind, std::uint64_t seed) {
  return {options.out / "series", stamp_of(subject.study), kind, seed};
}

/// Counts what is there already: rows and, of the first seed, the runs that pictures show.
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

/// Returns the study's own promises as judged, and behind them those of other commands.
std::vector<Judged> promises_of(const Rows& rows, Seeds seeds, const std::vector<Judged>& others) {
  std::vector<Judged> promises = judge(rows, seeds);
  promises.insert(promises.end(), others.begin(), others.end());
  return promises;
}

/// Measures what is missing, seed by seed, so that what an interruption leaves is whole comparisons of the floors.
Result<Ended> measure_all(const Subject& subject, const FloorOptions& options, const std::vector<Judged>& others,
                          Rows& rows, RowsMeasured& progress, const Surroundings& around) {
  for (std::uint64_t seed = options.seeds.first; seed <= options.seeds.last; ++seed) {
    for (const std::string& kind : subject.kinds) {
      const Result<Scenario> scenario = Scenario::make(subject.stage, kind, seed);
      if (!scenario) return fail(scenario.error());
      const auto keep = [&](const RowKey& key, const Score& score) {
        rows.insert_or_assign(key, score);
        progress.row(key.kind + ", " + key.part + ", seed " + std::to_string(key.seed));
        return write_rows(options.out, subject.study, rows, promises_of(rows, options.seeds, others));
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

/// Collects what pictures show, of the first seed.
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
  pictured.lights = subject.lights;
  pictured.seeds = options.seeds;
  pictured.camera_height_m = subject.stage.site.camera.height_m;
  pictured.about =
      "site " + subject.stage.site.name + ", method floor, " + std::to_string(std::lround(options.metres)) + " m";
  pictured.of_first = "seed " + std::to_string(seed) + ", repeated under: " + subject.lights.front();
  return Ended::complete;
}

/// Returns the rows that were asked for, without what other calls have left in the folder.
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

Result<Ended> report(const Subject& subject, const FloorOptions& options, const std::vector<Judged>& others,
                     const Rows& rows, const Pictured& pictured, const Surroundings& around) {
  if (const Result<void> csv = write_csv(options.out, rows); !csv) return fail(csv.error());
  const Result<void> written = write_rows(options.out, subject.study, rows, promises_of(rows, options.seeds, others));
  if (!written) return fail(written.error());
  const Rows asked = asked_for(rows, subject, options.seeds);
  if (const Result<void> kept = write_pictured(options.out, pictured); !kept) return fail(kept.error());
  const std::vector<std::string> pictures = draw_pictures("floor", options.out, around);
  const std::vector<Judged> promises = promises_of(asked, options.seeds, others);
  around.out << tables_of(promises, asked, options.seeds) << std::flush;
  around.progress << "weft-evaluate: floor.csv, floor.json and " << words_of(pictures) << " are in "
                  << options.out.string() << '\n';
  return is_any_missed(judge(asked, options.seeds)) ? Ended::missed : Ended::complete;
}

}  // namespace

Result<Ended> study_floor(const FloorOptions& options, const Surroundings& around) {
  const Result<Subject> subject = subject_of(options, around.asked_to_stop);
  if (!subject) return fail(subject.error());
  if (const Result<void> made = make_folder(options.out); !made) return fail(made.error());
  Result<Rows> rows = read_rows(options.out, subject->study);
  if (!rows) return fail(rows.error());
  const Result<std::vector<Judged>> others = judge_others(options.out, subject->study);
  if (!others) return fail(others.error());
  const std::size_t seeds = options.seeds.last - options.seeds.first + 1;
  const std::size_t all = subject->kinds.size() * (parts_of(*subject).size() * seeds + 1);
  RowsMeasured progress(all, kept_of(*rows, *subject, options), around);
  const Result<Ended> measured = measure_all(*subject, options, *others, *rows, progress, around);
  if (!measured || *measured == Ended::stopped) return measured;
  Pictured pictured;
  const Result<Ended> shown = show_all(*subject, options, pictured, progress);
  if (!shown || *shown == Ended::stopped) return shown;
  return report(*subject, options, *others, *rows, pictured, around);
}

}  // namespace weft::evaluate::floor
