#include "clients/evaluate/ceiling/study.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "clients/evaluate/ceiling/bounds.hpp"
#include "clients/evaluate/ceiling/rows.hpp"
#include "clients/evaluate/charts/draw.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/study_file.hpp"

namespace weft::evaluate::ceiling {
namespace {

/// Returns the rows of the table that are asked for; empty: all.
std::set<int> asked_rows(const Extent& extent) {
  return extent.is_quick ? std::set<int>{1, 2, 3, 6} : std::set<int>{};
}

/// Returns the rows that are to be there in the end, in the order in which they are measured: seed by seed, so that
/// what an interruption leaves is whole.
std::vector<RowKey> wanted(const CeilingOptions& options, bool has_recording) {
  std::vector<RowKey> keys;
  const auto is_asked = [&](const std::string& trial) { return options.trial.empty() || options.trial == trial; };
  if (has_recording && is_asked(trial::kFrames)) keys.emplace_back(trial::kFrames, 0);
  const std::vector<std::string> trials = driven_trials(options.extent);
  const Seeds most = seeds_of(trial::kLine, options.seeds);
  for (std::uint64_t seed = options.seeds.first; seed <= most.last; ++seed)
    for (const std::string& trial : trials)
      if (is_asked(trial) && seed <= seeds_of(trial, options.seeds).last) keys.emplace_back(trial, seed);
  return keys;
}

/// Measures what is missing, and keeps each row as soon as it is there.
class Measuring {
 public:
  Measuring(const CeilingOptions& options, const Study& study, const Scenes& scenes, Rows& rows,
            RowsMeasured& progress, const Surroundings& around)
      : options_(options), study_(study), scenes_(scenes), rows_(rows), progress_(progress), around_(around) {}

  Result<Ended> all(const std::vector<RowKey>& keys) {
    for (const RowKey& key : keys) {
      if (rows_.contains(key)) continue;
      const Result<std::optional<Measured>> measured = measure(key);
      if (!measured) return fail(measured.error());
      if (!*measured) return Ended::stopped;
      if (const Result<void> kept = keep(key, **measured); !kept) return fail(kept.error());
    }
    return Ended::complete;
  }

 private:
  Result<std::optional<Measured>> measure(const RowKey& key) {
    const auto& [trial, seed] = key;
    if (trial == trial::kFrames) return measure_recording(options_.recording, around_.asked_to_stop);
    if (!trials_ || seed_ != seed) {
      trials_.emplace(scenes_, options_.extent, seed, options_.out / "truth.now", around_.asked_to_stop);
      seed_ = seed;
    }
    return trials_->measure(trial);
  }

  Result<void> keep(const RowKey& key, const Measured& measured) {
    rows_.insert_or_assign(key, measured.score);
    if (key.second == options_.seeds.first && !measured.shown.empty())
      if (const Result<void> shown = write_shown(options_.out, key.first, measured.shown); !shown) return shown;
    progress_.row(key.first + ", seed " + std::to_string(key.second));
    return write_rows(options_.out, study_, rows_, judge(rows_, options_.seeds, asked_rows(options_.extent)));
  }

  const CeilingOptions& options_;
  const Study& study_;
  const Scenes& scenes_;
  Rows& rows_;
  RowsMeasured& progress_;
  const Surroundings& around_;
  std::optional<SeedTrials> trials_;
  std::uint64_t seed_ = 0;
};

Result<Ended> report_ceiling(const CeilingOptions& options, const Study& study, const Rows& rows,
                             const Surroundings& around) {
  const std::vector<Judged> judged = judge(rows, options.seeds, asked_rows(options.extent));
  if (const Result<void> csv = write_csv(options.out, rows); !csv) return fail(csv.error());
  if (const Result<void> kept = write_rows(options.out, study, rows, judged); !kept) return fail(kept.error());
  const nlohmann::json about = {
      {"about", "sites " + options.scenes.string() + ", method ceiling, " + words_of(options.seeds)},
      {"of_first", "seed " + std::to_string(options.seeds.first)}};
  if (const Result<void> kept = write_series(options.out, "ceiling", about); !kept) return fail(kept.error());
  const std::vector<std::string> pictures = draw_pictures("ceiling", options.out, around);
  around.out << table_of(judged) << std::flush;
  around.progress << "weft-evaluate: ceiling.csv, ceiling.json and " << evaluate::words_of(pictures) << " are in "
                  << options.out.string() << '\n';
  return is_any_missed(judged) ? Ended::missed : Ended::complete;
}

}  // namespace

Result<Ended> study_ceiling(const CeilingOptions& options, const Surroundings& around) {
  const Result<Scenes> scenes = read_scenes(options.scenes, options.extent.metres);
  if (!scenes) return fail(scenes.error());
  const bool has_recording = std::filesystem::is_directory(options.recording);
  if (!has_recording)
    around.progress << "weft-evaluate: no recording at " << options.recording.string()
                    << ": rows 1 and 2 are not measured; give one with --recording\n";
  if (const Result<void> made = make_folder(options.out); !made) return fail(made.error());
  const Study study{WEFT_VERSION, scenes->sha256, options.recording.string(), options.extent};
  Result<Rows> rows = read_rows(options.out, study);
  if (!rows) return fail(rows.error());
  const std::vector<RowKey> keys = wanted(options, has_recording);
  const auto kept = std::count_if(keys.begin(), keys.end(), [&](const RowKey& key) { return rows->contains(key); });
  RowsMeasured progress(keys.size(), static_cast<std::size_t>(kept), around);
  const Result<Ended> ended = Measuring(options, study, *scenes, *rows, progress, around).all(keys);
  if (!ended || *ended == Ended::stopped) return ended;
  return report_ceiling(options, study, *rows, around);
}

}  // namespace weft::evaluate::ceiling
