#include "clients/evaluate/particles/study.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "clients/evaluate/charts/draw.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/particles/carmen_log.hpp"
#include "clients/evaluate/particles/rows.hpp"
#include "clients/evaluate/particles/scan_map.hpp"
#include "clients/evaluate/particles/trial.hpp"
#include "clients/evaluate/study_file.hpp"

namespace weft::evaluate::particles {
namespace {

using nlohmann::json;

std::string study_name(const ParticlesOptions& options) {
  return options.is_anywhere ? "particles-global" : "particles";
}

/// Says what the rows were measured of.
json study_of(const ParticlesOptions& options, const std::vector<LaserScan>& scans) {
  std::string poses;
  for (const LaserScan& scan : scans)
    poses += std::to_string(scan.map_from_laser.x) + " " + std::to_string(scan.map_from_laser.y) + "\n";
  return {{"study", study_name(options)},
          {"log", options.log.filename().string()},
          {"poses", sha256_of(poses)},
          {"alpha", options.alpha},
          {"version", WEFT_VERSION}};
}

json points_of(const std::vector<Pose2>& poses) {
  json points = json::array();
  for (const Pose2& pose : poses) points.push_back({pose.x, pose.y});
  return points;
}

/// Writes for the picture the grid and the paths of one seed.
Result<void> write_shown(const ParticlesOptions& options, const agents::OccupancyGrid& grid, const Trial& trial) {
  const agents::Raster& raster = grid.raster;
  std::string cells;  // a letter a cell, the lowest row first
  for (const agents::CellState state : grid.cells) cells += "u.#"[static_cast<std::size_t>(state)];
  return write_series(options.out, study_name(options),
                      {{"log", options.log.filename().string()},
                       {"seed", trial.row.seed},
                       {"raster", {raster.x_m, raster.y_m, raster.cell_m, raster.columns, raster.rows}},
                       {"cells", cells},
                       {"truth", points_of(trial.truth)},
                       {"located", points_of(trial.located)}});
}

bool has_seed(const std::vector<TrialRow>& rows, std::uint64_t seed) {
  return std::any_of(rows.begin(), rows.end(), [&](const TrialRow& row) { return row.seed == seed; });
}

/// Measures the seeds that are not there yet.
Result<Ended> measure(const ParticlesOptions& options, const Course& course, const agents::OccupancyGrid& grid,
                      const json& study, std::vector<TrialRow>& rows, RowsMeasured& progress) {
  for (std::uint64_t seed = options.seeds.first; seed <= options.seeds.last; ++seed) {
    if (has_seed(rows, seed)) continue;
    const std::optional<Trial> trial = options.is_anywhere ? find(course, seed) : follow(course, seed);
    if (!trial) return Ended::stopped;
    rows.push_back(trial->row);
    if (seed == options.seeds.first)
      if (const Result<void> shown = write_shown(options, grid, *trial); !shown) return fail(shown.error());
    const Result<void> kept = write_rows(options.out / (study_name(options) + ".json"), study, rows);
    if (!kept) return fail(kept.error());
    progress.row("seed " + std::to_string(seed));
  }
  return Ended::complete;
}

Result<Ended> report(const ParticlesOptions& options, const json& study, std::vector<TrialRow> rows,
                     const Surroundings& around) {
  std::sort(rows.begin(), rows.end(), [](const TrialRow& a, const TrialRow& b) { return a.seed < b.seed; });
  std::erase_if(rows,
                [&](const TrialRow& row) { return row.seed < options.seeds.first || row.seed > options.seeds.last; });
  const std::string name = study_name(options);
  const Result<void> csv = write_rows_csv(options.out / (name + ".csv"), rows);
  if (!csv) return fail(csv.error());
  const std::vector<std::string> pictures = draw_pictures(name, options.out, around);
  const Asked asked = asked_of(options.log.filename().string(), options.alpha, options.is_anywhere);
  const Judged judged = judge(rows, asked, options.is_anywhere);
  around.out << (options.json ? judged_document(study, rows, asked, judged.is_met).dump() + "\n" : judged.table)
             << std::flush;
  around.progress << "weft-evaluate: " << name << ".csv, " << name << ".json and " << words_of(pictures) << " are in "
                  << options.out.string() << '\n';
  return judged.is_met ? Ended::complete : Ended::missed;
}

}  // namespace

Result<Ended> study_particles(const ParticlesOptions& options, const Surroundings& around) {
  const Result<std::vector<LaserScan>> scans = read_carmen_file(options.log);
  if (!scans) return fail(scans.error());
  if (const Result<void> made = make_folder(options.out); !made) return fail(made.error());
  const json study = study_of(options, *scans);
  Result<std::vector<TrialRow>> rows = read_rows(options.out / (study_name(options) + ".json"), study);
  if (!rows) return fail(rows.error());
  const double began_s = around.steady_s();
  const Result<agents::OccupancyGrid> grid = grid_of_even_scans(*scans);
  if (!grid) return fail(grid.error().code, options.log.string() + ": " + grid.error().message);
  around.progress << "weft-evaluate: " << scans->size() << " scans; a grid of " << grid->raster.columns << " by "
                  << grid->raster.rows << " cells in " << around.steady_s() - began_s << " s\n";
  const agents::LikelihoodField field = field_of(*grid, {});
  const Course course{*scans, field, anywhere_free(*grid), options.alpha, around.steady_s, around.asked_to_stop};
  std::size_t kept = 0;
  for (std::uint64_t seed = options.seeds.first; seed <= options.seeds.last; ++seed)
    kept += has_seed(*rows, seed) ? 1U : 0U;
  RowsMeasured progress(options.seeds.last - options.seeds.first + 1, kept, around);
  const Result<Ended> ended = measure(options, course, *grid, study, *rows, progress);
  if (!ended || *ended == Ended::stopped) return ended;
  return report(options, study, *std::move(rows), around);
}

}  // namespace weft::evaluate::particles
