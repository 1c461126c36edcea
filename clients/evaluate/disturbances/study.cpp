#include "clients/evaluate/disturbances/study.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "clients/evaluate/disturbances/lead.hpp"
#include "clients/evaluate/disturbances/picture.hpp"
#include "clients/evaluate/disturbances/rows.hpp"
#include "clients/evaluate/disturbances/switches.hpp"
#include "clients/evaluate/line.hpp"
#include "core/network/codec.hpp"

namespace weft::evaluate {
namespace {

Result<std::string> read_text(const std::filesystem::path& file, const std::string& what) {
  std::ifstream in(file, std::ios::binary);
  if (!in || !std::filesystem::is_regular_file(file)) {
    return fail(ErrorCode::not_found, file.string() + ": no such " + what);
  }
  return std::string{std::istreambuf_iterator<char>(in), {}};
}

std::string sha256_of(const std::string& text) {
  return to_string(hash_bytes({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
}

struct Subject {
  agents::sim::Site site;
  std::vector<agents::SitePoint> line;
  Study study;
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
  Study study{WEFT_VERSION, sha256_of(*site_text), sha256_of(*line_text), options.metres};
  return Subject{std::move(*site), std::move(*part), std::move(study)};
}

/// Rows there are to measure, and how fast it goes.
class RowsMeasured {
 public:
  RowsMeasured(std::size_t all, std::size_t kept, const Surroundings& around)
      : all_(all), kept_(kept), around_(around), began_s_(around.steady_s()) {
    around_.progress << "weft-evaluate: " << all_ << " rows to measure, " << kept_ << " of them are there already\n"
                     << std::flush;
  }
  void row(const std::string& variant, std::uint64_t seed) {
    ++measured_;
    const double each_s = (around_.steady_s() - began_s_) / static_cast<double>(measured_);
    const double left_s = each_s * static_cast<double>(all_ - kept_ - measured_);
    std::array<char, 200> words{};
    std::snprintf(words.data(), words.size(), "%zu of %zu (%s, seed %llu): %.1f s a row, %.0f min left\n",
                  kept_ + measured_, all_, variant.c_str(), static_cast<unsigned long long>(seed), each_s,
                  left_s / 60.0);
    around_.progress << words.data() << std::flush;
  }

 private:
  std::size_t all_, kept_, measured_ = 0;
  const Surroundings& around_;
  double began_s_;
};

std::size_t kept_of(const Rows& rows, const std::vector<Variant>& variants, Seeds seeds) {
  std::size_t kept = 0;
  for (const Variant& variant : variants) {
    for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
      kept += rows.count({name_of(variant), seed});
    }
  }
  return kept;
}

/// Seed by seed, so that what an interruption leaves is whole comparisons.
Result<Ended> measure_all(const Subject& subject, const DisturbancesOptions& options, Rows& rows,
                          const Surroundings& around) {
  const std::vector<Variant> variants = variants_of(subject.site.disturbances);
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
      progress.row(name_of(variant), seed);
    }
  }
  return Ended::complete;
}

std::string words_of(Seeds seeds) {
  if (seeds.first == seeds.last) return "seed " + std::to_string(seeds.first);
  return "seeds " + std::to_string(seeds.first) + " to " + std::to_string(seeds.last);
}

Result<void> report(const Subject& subject, const DisturbancesOptions& options, const Rows& rows, std::ostream& out) {
  std::vector<std::string> variants;
  for (const Variant& variant : variants_of(subject.site.disturbances)) variants.push_back(name_of(variant));
  if (const Result<void> csv = write_csv(options.out, variants, rows); !csv) return csv;
  const std::string about = "site " + subject.site.name + ", method floor, two runs over " +
                            std::to_string(std::lround(options.metres)) + " m, " + words_of(options.seeds);
  const std::filesystem::path picture = options.out / "disturbances.png";
  if (const Result<void> drawn = draw_disturbances(rows, disturbance_names(), options.seeds, about, picture);
      !drawn) {
    return drawn;
  }
  out << table_of(rows, variants, options.seeds) << std::flush;
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
  if (const Result<void> told = report(*subject, options, *rows, around.out); !told) return fail(told.error());
  around.progress << "weft-evaluate: disturbances.csv, .json and .png are in " << options.out.string() << '\n';
  return Ended::complete;
}

}  // namespace weft::evaluate
