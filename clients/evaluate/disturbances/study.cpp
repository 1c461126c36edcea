#include "clients/evaluate/disturbances/study.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "clients/evaluate/charts/draw.hpp"
#include "clients/evaluate/disturbances/lead.hpp"
#include "clients/evaluate/disturbances/rows.hpp"
#include "clients/evaluate/disturbances/summary.hpp"
#include "clients/evaluate/disturbances/switches.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/line.hpp"
#include "clients/evaluate/study_file.hpp"

namespace weft::evaluate {
namespace {

struct Subject {
  agents::sim::Site site;
  std::vector<agents::SitePoint> line;
  Study study;
  std::vector<Variant> all;     ///< that there are
  std::vector<Variant> chosen;  ///< to be measured
};

Result<Subject> subject_of(const DisturbancesOptions& options) {
  const Result<std::string> site_text = read_text(options.site, "site file; deploy/sites has some");
  if (!site_text) return fail(site_text.error());
  Result<agents::sim::Site> site = agents::sim::parse_site(*site_text, options.site.string());
  if (!site) return fail(site.error());
  const std::filesystem::path along =
      options.along.empty() ? options.site.parent_path() / options.site.stem() / "r1.line" : options.along;
  const Result<std::string> line_text = read_text(along, "line to drive along; give one with --along");
  if (!line_text) return fail(line_text.error());
  Result<std::vector<agents::SitePoint>> line = parse_line(*line_text, along.string());
  if (!line) return fail(line.error());
  Result<std::vector<agents::SitePoint>> part = first_metres(*line, options.metres, along.string());
  if (!part) return fail(part.error());
  std::vector<Variant> all = variants_of(site->disturbances);
  Result<std::vector<Variant>> chosen = named(all, options.only);
  if (!chosen) return fail(chosen.error());
  Study study{WEFT_VERSION, sha256_of(*site_text), sha256_of(*line_text), options.metres};
  return Subject{std::move(*site), std::move(*part), std::move(study), std::move(all), std::move(*chosen)};
}

std::size_t kept_of(const Rows& rows, const std::vector<Variant>& variants, Seeds seeds) {
  std::size_t kept = 0;
  for (const Variant& variant : variants) {
    for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
      kept += rows.count({name_of(variant), seed});
    }
  }
  return kept;
}

/// Measures every row that is missing, seed by seed, so that what an interruption leaves is whole comparisons.
Result<Ended> measure_all(const Subject& subject, const DisturbancesOptions& options, Rows& rows,
                          const Surroundings& around) {
  const std::vector<Variant>& variants = subject.chosen;
  const std::size_t all = variants.size() * (options.seeds.last - options.seeds.first + 1);
  RowsMeasured progress(all, kept_of(rows, variants, options.seeds), around);
  LeadTask task{subject.site, subject.line, 1, options.out / "truth.now", around.asked_to_stop};
  for (std::uint64_t seed = options.seeds.first; seed <= options.seeds.last; ++seed) {
    for (const Variant& variant : variants) {
      if (rows.contains({name_of(variant), seed})) continue;
      task.seed = seed;
      task.site.disturbances = variant.disturbances;
      const Result<std::optional<Score>> score = measure(task);
      if (!score) return fail(score.error());
      if (!*score) return Ended::stopped;
      rows.insert_or_assign({name_of(variant), seed}, **score);
      if (const Result<void> kept = write_rows(options.out, subject.study, rows); !kept) return fail(kept.error());
      progress.row(name_of(variant) + ", seed " + std::to_string(seed));
    }
  }
  return Ended::complete;
}

std::vector<std::string> names_of(const std::vector<Variant>& variants) {
  std::vector<std::string> names;
  for (const Variant& variant : variants) names.push_back(name_of(variant));
  return names;
}

/// Returns the disturbances that any of these variants are about.
std::vector<std::string> disturbances_of(const std::vector<Variant>& variants) {
  std::vector<std::string> names = disturbance_names();
  std::erase_if(names, [&](const std::string& name) {
    return std::none_of(variants.begin(), variants.end(),
                        [&](const Variant& variant) { return variant.disturbance == name; });
  });
  return names;
}

Result<void> report(const Subject& subject, const DisturbancesOptions& options, const Rows& rows,
                    const Surroundings& around) {
  if (const Result<void> csv = write_csv(options.out, names_of(subject.all), rows); !csv) return csv;
  const std::string about = "site " + subject.site.name + ", method floor, two runs over " +
                            std::to_string(std::lround(options.metres)) + " m, " + words_of(options.seeds);
  const nlohmann::json series = {{"about", about},
                                 {"seeds", {options.seeds.first, options.seeds.last}},
                                 {"disturbances", disturbances_of(subject.chosen)}};
  if (const Result<void> kept = write_series(options.out, "disturbances", series); !kept) return kept;
  const std::vector<std::string> pictures = draw_pictures("disturbances", options.out, around);
  around.out << table_of(rows, names_of(subject.chosen), options.seeds) << std::flush;
  around.progress << "weft-evaluate: disturbances.csv, .json and " << words_of(pictures) << " are in "
                  << options.out.string() << '\n';
  return {};
}

}  // namespace

Result<Ended> study_disturbances(const DisturbancesOptions& options, const Surroundings& around) {
  const Result<Subject> subject = subject_of(options);
  if (!subject) return fail(subject.error());
  std::error_code problem;
  std::filesystem::create_directories(options.out, problem);
  if (problem) return fail(ErrorCode::unavailable, options.out.string() + ": " + problem.message());
  Result<Rows> rows = read_rows(options.out, subject->study);
  if (!rows) return fail(rows.error());
  const Result<Ended> ended = measure_all(*subject, options, *rows, around);
  if (!ended || *ended == Ended::stopped) return ended;
  if (const Result<void> told = report(*subject, options, *rows, around); !told) return fail(told.error());
  return Ended::complete;
}

}  // namespace weft::evaluate
