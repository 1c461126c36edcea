#include "clients/evaluate/topometric/study.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "clients/evaluate/charts/draw.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/study_file.hpp"
#include "clients/evaluate/topometric/bounds.hpp"
#include "clients/evaluate/topometric/rows.hpp"
#include "clients/evaluate/topometric/trials.hpp"

namespace weft::evaluate::topometric {
namespace {

/// Returns the rows that are to be there in the end, seed by seed: what an interruption leaves is whole.
std::vector<RowKey> wanted_rows(const TopometricOptions& options) {
  const std::vector<std::string> trials =
      options.trial.empty() ? usual_trials(options.extent) : std::vector<std::string>{options.trial};
  std::vector<RowKey> keys;
  for (std::uint64_t seed = options.seeds.first; seed <= options.seeds.last; ++seed)
    for (const std::string& trial : trials)
      if (seed <= seeds_of(trial, options.seeds).last) keys.emplace_back(trial, seed);
  return keys;
}

/// Measures what is missing, and keeps each row as soon as it is there.
class MeasuringTopometric {
 public:
  MeasuringTopometric(const TopometricOptions& options, const Study& study, const Scenes& scenes, Rows& rows,
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
    if (!trials_ || seed_ != seed) {
      trials_.emplace(scenes_, options_.extent, Driven{seed, options_.out / "truth.now", around_.asked_to_stop});
      seed_ = seed;
    }
    return trials_->measure(trial);
  }

  Result<void> keep(const RowKey& key, const Measured& measured) {
    rows_.insert_or_assign(key, measured.score);
    if (key.second == options_.seeds.first && !measured.shown.empty())
      if (const Result<void> shown = write_shown(options_.out, key.first, measured.shown); !shown) return shown;
    std::string about = key.first + ", seed " + std::to_string(key.second);
    for (const std::string& said : measured.said) about += ", " + said;
    progress_.row(about);
    return write_rows(options_.out, study_, rows_, judge(rows_, options_.seeds, options_.extent.is_quick));
  }

  const TopometricOptions& options_;
  const Study& study_;
  const Scenes& scenes_;
  Rows& rows_;
  RowsMeasured& progress_;
  const Surroundings& around_;
  std::optional<SeedTrials> trials_;
  std::uint64_t seed_ = 0;
};

Result<Ended> report_topometric(const TopometricOptions& options, const Study& study, const Rows& rows,
                                const Surroundings& around) {
  const std::vector<Judged> judged = judge(rows, options.seeds, options.extent.is_quick);
  if (const Result<void> csv = write_csv(options.out, rows); !csv) return fail(csv.error());
  if (const Result<void> kept = write_rows(options.out, study, rows, judged); !kept) return fail(kept.error());
  nlohmann::json about = {
      {"about", "sites " + options.scenes.string() + ", method topometric, " + evaluate::words_of(options.seeds)}};
  if (options.seeds.last != options.seeds.first)
    about["of_first"] = "drawn: seed " + std::to_string(options.seeds.first);
  if (const Result<void> kept = write_series(options.out, "topometric", about); !kept) return fail(kept.error());
  const std::vector<std::string> pictures = draw_pictures("topometric", options.out, around);
  around.out << (options.is_json ? document_of(study, rows, judged).dump() + "\n" : table_of(judged)) << std::flush;
  around.progress << "weft-evaluate: topometric.csv, topometric.json and " << evaluate::words_of(pictures)
                  << " are in " << options.out.string() << '\n';
  return is_any_missed(judged) ? Ended::missed : Ended::complete;
}

void say_time(double took_s, const Surroundings& around) {
  std::array<char, 100> words{};
  std::snprintf(words.data(), words.size(), "weft-evaluate: took %.0f min %.0f s\n", std::floor(took_s / 60.0),
                std::fmod(took_s, 60.0));
  around.progress << words.data() << std::flush;
}

}  // namespace

Result<Ended> study_topometric(const TopometricOptions& options, const Surroundings& around) {
  const double began_s = around.steady_s();
  const Result<Scenes> scenes = read_scenes(options.scenes, options.extent);
  if (!scenes) return fail(scenes.error());
  if (const Result<void> made = make_folder(options.out); !made) return fail(made.error());
  const Study study{WEFT_VERSION, scenes->sha256, options.extent};
  Result<Rows> rows = read_rows(options.out, study);
  if (!rows) return fail(rows.error());
  const std::vector<RowKey> keys = wanted_rows(options);
  const auto kept = std::count_if(keys.begin(), keys.end(), [&](const RowKey& key) { return rows->contains(key); });
  RowsMeasured progress(keys.size(), static_cast<std::size_t>(kept), around);
  const Result<Ended> ended = MeasuringTopometric(options, study, *scenes, *rows, progress, around).all(keys);
  say_time(around.steady_s() - began_s, around);
  if (!ended || *ended == Ended::stopped) return ended;
  return report_topometric(options, study, *rows, around);
}

}  // namespace weft::evaluate::topometric
