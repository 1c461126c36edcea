#include "clients/evaluate/bearing/learning.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "clients/evaluate/bearing/chosen.hpp"
#include "clients/evaluate/bearing/days.hpp"
#include "clients/evaluate/bearing/rows.hpp"
#include "clients/evaluate/bearing/trials.hpp"
#include "clients/evaluate/csv.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/table.hpp"

namespace weft::evaluate::bearing {
namespace {

/// Holds how driving went on one day.
struct DayScore {
  double votes = 0.0;    ///< a view that told where the robot is
  double told = 0.0;     ///< share of views
  double error_m = 0.0;  ///< mean, from where it believes to be on the taught way
  double end_m = 0.0;    ///< at the end
  double learned_places = 0.0;
  std::string ended;  ///< why it stands; empty: it came round
};

struct RowOfDay {
  std::string days, day;
  std::uint64_t seed = 0;
  std::size_t number = 0;
  bool learns = false;
  DayScore score;
};

DayScore score_of(const Repeated& repeated) {
  DayScore score;
  score.votes = repeated.votes / static_cast<double>(std::max<std::size_t>(1, repeated.fixes));
  score.told = static_cast<double>(repeated.fixes) / static_cast<double>(std::max<std::size_t>(1, repeated.looks));
  for (const Deviation& one : repeated.along) score.error_m += one.path_from_robot.translation().norm();
  score.error_m /= static_cast<double>(std::max<std::size_t>(1, repeated.along.size()));
  score.end_m =
      repeated.after_loop.empty() ? Score::kNothing : repeated.after_loop.back().path_from_robot.translation().norm();
  score.learned_places = static_cast<double>(repeated.learned_places.size());
  score.ended = repeated.ended;
  return score;
}

/// Drives all days one after the other, with learning or without. Returns false when it was stopped.
Result<bool> live(const Days& days, const Scene& scene, Course course, std::uint64_t seed, bool learns,
                  const Surroundings& around, std::vector<RowOfDay>& rows) {
  const Pose2 a_little_aside{0.0, -0.1, 0.0};
  for (std::size_t i = 0; i < days.days.size(); ++i) {
    Drive drive = drive_of(scene, seed, i + 1, around.asked_to_stop);
    days.days[i].as(drive.body.site);
    const auto repeated = repeat(drive, course, {a_little_aside}, 1, Parts::all);
    if (!repeated) return fail(repeated.error());
    if (!*repeated) return false;
    for (const agents::LearnedPlace& learned_place : (*repeated)->learned_places)
      if (learns) course.map.take(learned_place);
    rows.push_back({days.name, days.days[i].about, seed, i + 1, learns, score_of(**repeated)});
  }
  return true;
}

std::string csv_of(const std::vector<RowOfDay>& rows) {
  CsvText csv(
      {"days", "seed", "learns", "number", "day", "votes", "told", "error_m", "end_m", "learned_places", "ended"});
  for (const RowOfDay& row : rows) {
    const DayScore& score = row.score;
    csv.value(row.days).value(row.seed).value(row.learns).value(row.number).words(row.day);
    csv.value(score.votes).value(score.told).value(score.error_m).value(score.end_m).value(score.learned_places);
    csv.words(score.ended).end_row();
  }
  return csv.text();
}

/// Returns the table of means over the seeds, with learning beside without.
std::string table_of(const std::vector<RowOfDay>& rows) {
  struct Sum {
    std::string about;
    double seeds = 0.0, votes = 0.0, told = 0.0, error_m = 0.0, learned_places = 0.0;
  };
  std::map<std::tuple<std::string, std::size_t, bool>, Sum> sums;
  for (const RowOfDay& row : rows) {
    Sum& sum = sums[{row.days, row.number, row.learns}];
    sum.about = row.day;
    sum.seeds += 1.0;
    sum.votes += row.score.votes;
    sum.told += row.score.told;
    sum.error_m += row.score.error_m;
    sum.learned_places += row.score.learned_places;
  }
  std::vector<std::vector<std::string>> table = {{"days", "day", "votes", "with learning", "told, %", "with learning",
                                                  "error, m", "with learning", "learned_places"}};
  for (const auto& [key, without] : sums) {
    if (std::get<2>(key)) continue;
    const auto with = sums.find({std::get<0>(key), std::get<1>(key), true});
    if (with == sums.end()) continue;
    const Sum& learned = with->second;
    table.push_back({std::get<0>(key), std::to_string(std::get<1>(key)) + " " + without.about,
                     cell(without.votes / without.seeds, 1), cell(learned.votes / learned.seeds, 1),
                     cell(100.0 * without.told / without.seeds, 1), cell(100.0 * learned.told / learned.seeds, 1),
                     cell(without.error_m / without.seeds, 3), cell(learned.error_m / learned.seeds, 3),
                     cell(learned.learned_places / learned.seeds, 0)});
  }
  return markdown_table(table, 2);
}

}  // namespace

Result<Ended> study_learning(const LearningOptions& options, const Surroundings& around) {
  const Result<std::vector<Days>> some = chosen(all_days(), options.days, "--days");
  if (!some) return fail(some.error());
  const Result<Scene> scene = read_scene(options.scenes, options.line, options.line);
  if (!scene) return fail(scene.error());
  if (const Result<void> made = make_folder(options.out); !made) return fail(made.error());
  std::vector<RowOfDay> rows;
  RowsMeasured progress(2 * some->size() * (options.seeds.last - options.seeds.first + 1), 0, around);
  for (std::uint64_t seed = options.seeds.first; seed <= options.seeds.last; ++seed) {
    const Result<std::optional<Course>> course = teach(drive_of(*scene, seed, 0, around.asked_to_stop), scene->line);
    if (!course) return fail(course.error());
    if (!*course) return Ended::stopped;
    for (const Days& days : *some) {
      for (const bool learns : {false, true}) {
        const Result<bool> lived = live(days, *scene, **course, seed, learns, around, rows);
        if (!lived) return fail(lived.error());
        if (!*lived) return Ended::stopped;
        if (const auto kept = write_text(options.out / "learning.csv", csv_of(rows)); !kept)
          return fail(kept.error());
        progress.row(days.name + (learns ? ", learning" : "") + ", seed " + std::to_string(seed));
      }
    }
  }
  around.out << table_of(rows) << std::flush;
  return Ended::complete;
}

}  // namespace weft::evaluate::bearing
