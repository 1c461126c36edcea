#include "clients/evaluate/floor/relocalise/relocalise_study.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

#include "clients/evaluate/charts/draw.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/floor/relocalise/hall.hpp"
#include "clients/evaluate/floor/relocalise/trial.hpp"
#include "clients/evaluate/floor/relocalise/trial_report.hpp"
#include "clients/evaluate/floor/relocalise/trial_rows.hpp"
#include "clients/evaluate/study_file.hpp"

namespace weft::evaluate::floor {
namespace {

constexpr std::size_t kKeptEvery = 25;  // trials

/// Describes a drive to teach a network as long as this one: a hand that walks and a view every decimetre give what
/// thirty views a second give, as places stand 0.2 m apart. The robots that look for themselves see as the site says.
Drive teaching(const Scenario& scenario) {
  Drive drive = scenario.first();
  drive.body.site.camera.fps = 10.0;
  drive.body.site.hand.speed_m_s = 0.95;
  drive.body.site.hand.speed_wander_m_s = std::min(0.05, drive.body.site.hand.speed_wander_m_s);
  return drive;
}

/// Teaches the scenario's network. None: stopped.
Result<std::optional<Taught>> network_of(const Scenario& scenario) {
  Taught taught;
  const Result<bool> done = teach(teaching(scenario), scenario.line(), taught);
  if (!done) return fail(done.error());
  return *done ? std::optional(std::move(taught)) : std::nullopt;
}

std::size_t trials_in(const TrialRows& rows, const RowKey& key) {
  const auto found = rows.find(key);
  return found == rows.end() ? 0 : found->second.size();
}

/// Holds what a study needs at every step, beside its options.
struct Trials {
  const Subject& subject;
  const RelocaliseOptions& options;
  TrialRows& rows;
  RowsMeasured& progress;

  Result<void> keep() const { return write_trials(options.out, subject.study, rows); }
};

/// Tries what a row lacks of its trials, half of them each way.
Result<Ended> fill_row(const Trials& study, const RowKey& key, const Scenario& scenario, const Taught& taught) {
  const Result<Drive> drive = scenario.second(key.part);
  if (!drive) return fail(drive.error());
  Result<Pushed> robot = Pushed::make(*drive);
  if (!robot) return fail(robot.error());
  if (const Result<void> learnt = robot->learn(taught); !learnt) return fail(learnt.error());
  std::vector<Trial>& trials = study.rows[key];
  while (trials.size() < study.options.trials) {
    Random random = Random(key.seed).fork(trials.size());
    const Along along = trials.size() % 2 == 0 ? Along::forwards : Along::backwards;
    const Result<std::optional<Trial>> trial = robot->push(some_push(scenario.line(), along, random), taught);
    if (!trial) return fail(trial.error());
    if (!*trial) return Ended::stopped;
    trials.push_back(**trial);
    if (trials.size() % kKeptEvery != 0 && trials.size() < study.options.trials) continue;
    const auto found =
        std::count_if(trials.begin(), trials.end(), [](const Trial& one) { return one.found_m && !one.is_wrong; });
    const auto wrong = std::count_if(trials.begin(), trials.end(), [](const Trial& one) { return one.is_wrong; });
    study.progress.row(key.kind + ", " + key.part + ", seed " + std::to_string(key.seed) + ": " +
                       std::to_string(found) + " of " + std::to_string(trials.size()) + " found, " +
                       std::to_string(wrong) + " WRONG");
    if (const Result<void> kept = study.keep(); !kept) return fail(kept.error());
  }
  return Ended::complete;
}

Result<Ended> try_all(const Trials& study) {
  const Seeds seeds = study.options.seeds;
  for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
    for (const std::string& kind : study.subject.kinds) {
      const Result<Scenario> scenario = Scenario::make(study.subject.stage, kind, seed);
      if (!scenario) return fail(scenario.error());
      std::optional<Taught> taught;
      for (const std::string& light : study.subject.lights) {
        const RowKey key{kind, light, seed};
        if (trials_in(study.rows, key) >= study.options.trials) continue;
        if (!taught) {
          Result<std::optional<Taught>> made = network_of(*scenario);
          if (!made) return fail(made.error());
          if (!*made) return Ended::stopped;
          taught = std::move(*made);
        }
        const Result<Ended> ended = fill_row(study, key, *scenario, *taught);
        if (!ended || *ended == Ended::stopped) return ended;
      }
    }
  }
  return Ended::complete;
}

/// Writes for the picture the taught way, and how far robots are pushed.
Result<void> write_line(const Trials& study, const std::string& about) {
  nlohmann::json series = {{"about", about}, {"push_m", kPushM}, {"line", nlohmann::json::array()}};
  for (const agents::SitePoint& point : study.subject.stage.line) series["line"].push_back({point.x, point.y});
  return write_series(study.options.out, "floor-relocalise", series);
}

Result<Ended> report_trials(const Trials& study, const Surroundings& around) {
  TrialRows asked;
  std::size_t count = 0;
  std::size_t wrong = 0;
  for (const auto& [key, trials] : study.rows) {
    const Subject& subject = study.subject;
    const Seeds seeds = study.options.seeds;
    const bool is_asked = std::find(subject.kinds.begin(), subject.kinds.end(), key.kind) != subject.kinds.end() &&
                          std::find(subject.lights.begin(), subject.lights.end(), key.part) != subject.lights.end() &&
                          key.seed >= seeds.first && key.seed <= seeds.last;
    if (!is_asked) continue;
    asked.emplace(key, trials);
    count += trials.size();
    wrong += static_cast<std::size_t>(
        std::count_if(trials.begin(), trials.end(), [](const Trial& trial) { return trial.is_wrong; }));
  }
  const std::filesystem::path& out = study.options.out;
  if (const Result<void> csv = write_trials_csv(out, asked); !csv) return fail(csv.error());
  const std::string about = "site " + study.subject.stage.site.name + "'s robots, method floor, " +
                            std::to_string(static_cast<int>(study.options.metres)) + " m of network, " +
                            words_of(study.options.seeds) + ", " + std::to_string(count) + " trials";
  if (const Result<void> kept = write_line(study, about); !kept) return fail(kept.error());
  const std::vector<std::string> pictures = draw_pictures("floor-relocalise", out, around);
  around.out << tables_of(asked) << std::flush;
  around.progress << "weft-evaluate: relocalise.csv, relocalise.json and " << words_of(pictures) << " are in "
                  << out.string() << '\n';
  const std::vector<TrialGroup> groups = judge(asked);
  const bool all_met = std::all_of(groups.begin(), groups.end(), [](const TrialGroup& group) { return group.met; });
  if (wrong == 0) return all_met ? Ended::complete : Ended::missed;
  return fail(ErrorCode::refused, std::to_string(wrong) + " of " + std::to_string(count) +
                                      " robots believed a wrong place; " + (out / "relocalise.csv").string() +
                                      " names each");
}

}  // namespace

Result<Ended> study_relocalisation(const RelocaliseOptions& options, const Surroundings& around) {
  Result<Subject> subject = subject_without_line(options, around.asked_to_stop);
  if (!subject) return fail(subject.error());
  Hall hall = hall_like(subject->stage.site, options.metres);
  subject->stage.site = std::move(hall.site);
  subject->stage.line = std::move(hall.line);
  if (const Result<void> made = make_folder(options.out); !made) return fail(made.error());
  Result<TrialRows> rows = read_trials(options.out, subject->study);
  if (!rows) return fail(rows.error());
  const std::size_t pieces = (options.trials + kKeptEvery - 1) / kKeptEvery;
  std::size_t all = 0;
  std::size_t kept = 0;
  for (std::uint64_t seed = options.seeds.first; seed <= options.seeds.last; ++seed) {
    for (const std::string& kind : subject->kinds) {
      for (const std::string& light : subject->lights) {
        all += pieces;
        kept += std::min(pieces, trials_in(*rows, {kind, light, seed}) / kKeptEvery);
      }
    }
  }
  RowsMeasured progress(all, kept, around);
  const Trials study{*subject, options, *rows, progress};
  const Result<Ended> ended = try_all(study);
  if (!ended || *ended == Ended::stopped) return ended;
  return report_trials(study, around);
}

}  // namespace weft::evaluate::floor
