#include "clients/evaluate/bearing/study.hpp"

#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "clients/evaluate/bearing/bounds.hpp"
#include "clients/evaluate/bearing/chosen.hpp"
#include "clients/evaluate/bearing/shown.hpp"
#include "clients/evaluate/bearing/trials.hpp"
#include "clients/evaluate/charts/draw.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/study_file.hpp"

namespace weft::evaluate::bearing {
namespace {

using Scenes = std::map<std::string, Scene>;  // by line

Result<Scenes> read_scenes(const std::filesystem::path& folder) {
  Scenes scenes;
  for (const Trial& trial : trials()) {
    if (scenes.contains(trial.line)) continue;
    Result<Scene> scene = read_scene(folder, trial.site, trial.line);
    if (!scene) return fail(scene.error());
    scenes.emplace(trial.line, std::move(*scene));
  }
  return scenes;
}

Study study_of(const Scenes& scenes) {
  std::string all;
  for (const auto& [name, scene] : scenes) all += name + " " + scene.sha256 + "\n";
  return {WEFT_VERSION, sha256_of(all)};
}

struct Measured {
  Score score;
  Shown shown;
};

/// Scores a way that could not be taught as one on which the robot did not come back, instead of leaving it out.
Measured not_taught(const std::string& why) {
  Measured measured;
  measured.score.ended = why;
  return measured;
}

/// Teaches and repeats the trial's way, and scores it. None: stopped.
Result<std::optional<Measured>> measure(const Trial& trial, const Scene& scene, std::uint64_t seed,
                                        const Surroundings& around) {
  Drive taught_in = drive_of(scene, seed, 0, around.asked_to_stop);
  trial.as_taught(taught_in.body.site);
  const Result<std::optional<Course>> course = teach(taught_in, scene.line);
  if (!course && course.error().code == ErrorCode::refused) return std::optional(not_taught(course.error().message));
  if (!course) return fail(course.error());
  if (!*course) return std::optional<Measured>();
  Drive repeated_in = drive_of(scene, seed, 1, around.asked_to_stop);
  trial.as_repeated(repeated_in.body.site);
  const auto repeated = repeat(repeated_in, **course, {trial.start_from_robot}, trial.loops, trial.parts);
  if (!repeated) return fail(repeated.error());
  if (!*repeated) return std::optional<Measured>();
  const Result<double> landmark_m = landmark_distance_m(taught_in.body.site, **course);
  if (!landmark_m) return fail(landmark_m.error());
  Measured measured;
  Score& score = measured.score;
  for (const Deviation& end : (*repeated)->after_loop)
    score.after_loop_m.push_back(end.path_from_robot.translation().norm());
  score.ended = (*repeated)->ended;
  score.landmark_m = *landmark_m;
  std::vector<ErrorAt> first_loop;
  std::vector<ErrorAt> model;
  if (!(*repeated)->along.empty()) {
    score.metres = (*repeated)->along.back().driven_m;
    first_loop = first_loop_of(**repeated, **course);
    const bool steers_by_model = trial.parts == Parts::all || trial.parts == Parts::heading_only;
    if (steers_by_model) {
      model = modelled(**course, trial.start_from_robot.translation(), *landmark_m);
      score.band_m = band_of(first_loop, model);
    }
    measured.shown = shown_of(**course, **repeated, first_loop, model);
  }
  return std::optional(std::move(measured));
}

std::filesystem::path series_of(const BearingOptions& options, const Study& study) {
  return options.out / "series" /
         (study.scenes_sha256.substr(0, 16) + "-seed-" + std::to_string(options.seeds.first));
}

Result<Ended> measure_all(const std::vector<Trial>& some, const Scenes& scenes, const BearingOptions& options,
                          const Study& study, Rows& rows, const Surroundings& around) {
  const std::size_t all = some.size() * (options.seeds.last - options.seeds.first + 1);
  std::size_t kept = 0;
  for (const Trial& trial : some) kept += errors_after(rows, options.seeds, trial.name, 1).size();
  RowsMeasured progress(all, kept, around);
  for (std::uint64_t seed = options.seeds.first; seed <= options.seeds.last; ++seed) {
    for (const Trial& trial : some) {
      if (rows.contains({trial.name, seed})) continue;
      const auto measured = measure(trial, scenes.at(trial.line), seed, around);
      if (!measured)
        return fail(measured.error().code,
                    trial.name + ", seed " + std::to_string(seed) + ": " + measured.error().message);
      if (!*measured) return Ended::stopped;
      if (seed == options.seeds.first) {
        const Result<void> written = write_shown(series_of(options, study), trial.name, (*measured)->shown);
        if (!written) return fail(written.error());
      }
      rows.insert_or_assign({trial.name, seed}, (*measured)->score);
      progress.row(trial.name + ", seed " + std::to_string(seed));
      if (const auto kept_row = write_rows(options.out, study, rows, options.seeds); !kept_row)
        return fail(kept_row.error());
    }
  }
  return Ended::complete;
}

/// Writes for pictures the trials in their order, and the seeds asked for.
Result<void> write_trials(const BearingOptions& options) {
  nlohmann::json document = {{"seeds", {options.seeds.first, options.seeds.last}},
                             {"trials", nlohmann::json::array()}};
  for (const Trial& trial : trials()) {
    const bool is_ablation = trial.parts == Parts::profile_only || trial.parts == Parts::vision_only;
    document["trials"].push_back({{"name", trial.name}, {"about", trial.about}, {"is_ablation", is_ablation}});
  }
  return write_series(options.out, "bearing", document);
}

}  // namespace

Result<Ended> study_bearing(const BearingOptions& options, const Surroundings& around) {
  const Result<std::vector<Trial>> some = chosen(trials(), options.trial, "--trial");
  if (!some) return fail(some.error());
  const Result<Scenes> scenes = read_scenes(options.scenes);
  if (!scenes) return fail(scenes.error());
  const Study study = study_of(*scenes);
  if (const Result<void> made = make_folder(options.out); !made) return fail(made.error());
  Result<Rows> rows = read_rows(options.out, study);
  if (!rows) return fail(rows.error());
  const Result<Ended> measured = measure_all(*some, *scenes, options, study, *rows, around);
  if (!measured || *measured == Ended::stopped) return measured;
  if (const Result<void> csv = write_csv(options.out, *rows); !csv) return fail(csv.error());
  if (const Result<void> kept = write_trials(options); !kept) return fail(kept.error());
  const std::vector<std::string> pictures = draw_pictures("bearing", options.out, around);
  around.out << tables_of(*rows, options.seeds) << std::flush;
  around.progress << "weft-evaluate: bearing.csv, bearing.json and " << words_of(pictures) << " are in "
                  << options.out.string() << '\n';
  return is_any_missed(judge(*rows, options.seeds)) ? Ended::missed : Ended::complete;
}

}  // namespace weft::evaluate::bearing
