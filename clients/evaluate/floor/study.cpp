#include "clients/evaluate/floor/study.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "agents/bodies/sim/changes.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/floor/bounds.hpp"
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

/// Rows of one floor and one seed: taught once, then repeated under each light. Each is handed on as soon as it is
/// there.
class Measurement {
 public:
  using Keep = std::function<Result<void>(const RowKey&, const Score&)>;

  Measurement(const Scenario& scenario, std::string kind, std::uint64_t seed, const Surroundings& around, Keep keep)
      : scenario_(scenario), kind_(std::move(kind)), seed_(seed), around_(around), keep_(std::move(keep)) {}

  Result<Ended> mapping() {
    const double began_s = around_.steady_s();
    if (const Result<Ended> ended = teach_once(); !ended || *ended == Ended::stopped) return ended;
    const Result<std::optional<Trace>> wrong_mount = lead(scenario_.with_wrong_mount(), scenario_.line());
    if (!wrong_mount) return fail(wrong_mount.error());
    if (!*wrong_mount) return Ended::stopped;
    const Result<std::optional<Trace>> fast = lead(scenario_.fast(), scenario_.fast_line());
    if (!fast) return fail(fast.error());
    if (!*fast) return Ended::stopped;
    return keep(kMapping, score_of_mapping(taught_->trace, **wrong_mount, **fast), began_s);
  }

  Result<Ended> repeat_under(const std::string& light) {
    const double began_s = around_.steady_s();
    if (const Result<Ended> ended = teach_once(); !ended || *ended == Ended::stopped) return ended;
    const Result<Drive> drive = scenario_.second(light);
    if (!drive) return fail(drive.error());
    const Result<std::optional<Repeated>> repeated = repeat(*drive, *taught_);
    if (!repeated) return fail(repeated.error());
    if (!*repeated) return Ended::stopped;
    return keep(light, score_of_repeat(*taught_, **repeated), began_s);
  }

 private:
  Result<Ended> teach_once() {
    if (taught_) return Ended::complete;
    Result<std::optional<Taught>> taught = teach(scenario_.first(), scenario_.line());
    if (!taught) return fail(taught.error());
    if (!*taught) return Ended::stopped;
    taught_ = std::move(*taught);
    return Ended::complete;
  }

  Result<Ended> keep(const std::string& part, Score score, double began_s) {
    score.seconds = around_.steady_s() - began_s;
    if (const Result<void> kept = keep_({kind_, part, seed_}, score); !kept) return fail(kept.error());
    return Ended::complete;
  }

  const Scenario& scenario_;
  std::string kind_;
  std::uint64_t seed_;
  const Surroundings& around_;
  Keep keep_;
  std::optional<Taught> taught_;
};

std::vector<std::string> parts_of(const Subject& subject) {
  std::vector<std::string> parts = {kMapping};
  parts.insert(parts.end(), subject.lights.begin(), subject.lights.end());
  return parts;
}

std::size_t kept_of(const Rows& rows, const Subject& subject, Seeds seeds) {
  std::size_t kept = 0;
  for (const std::string& kind : subject.kinds) {
    for (std::uint64_t seed = seeds.first; seed <= seeds.last; ++seed) {
      for (const std::string& part : parts_of(subject)) kept += rows.count({kind, part, seed});
    }
  }
  return kept;
}

/// Seed by seed, so that what an interruption leaves is whole comparisons of the floors.
Result<Ended> measure_all(const Subject& subject, const FloorOptions& options, Rows& rows,
                          const Surroundings& around) {
  const std::vector<std::string> parts = parts_of(subject);
  const std::size_t all = subject.kinds.size() * parts.size() * (options.seeds.last - options.seeds.first + 1);
  RowsMeasured progress(all, kept_of(rows, subject, options.seeds), around);
  for (std::uint64_t seed = options.seeds.first; seed <= options.seeds.last; ++seed) {
    for (const std::string& kind : subject.kinds) {
      const Result<Scenario> scenario = Scenario::make(subject.stage, kind, seed);
      if (!scenario) return fail(scenario.error());
      Measurement measurement(*scenario, kind, seed, around, [&](const RowKey& key, const Score& score) {
        rows.insert_or_assign(key, score);
        progress.row(key.kind + ", " + key.part + ", seed " + std::to_string(key.seed));
        return write_rows(options.out, subject.study, rows, options.seeds);
      });
      for (const std::string& part : parts) {
        if (rows.contains({kind, part, seed})) continue;
        const Result<Ended> ended = part == kMapping ? measurement.mapping() : measurement.repeat_under(part);
        if (!ended || *ended == Ended::stopped) return ended;
      }
    }
  }
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

}  // namespace

Result<Ended> study_floor(const FloorOptions& options, const Surroundings& around) {
  const Result<Subject> subject = subject_of(options, around);
  if (!subject) return fail(subject.error());
  std::error_code problem;
  std::filesystem::create_directories(options.out, problem);
  if (problem) return fail(ErrorCode::unavailable, options.out.string() + ": " + problem.message());
  Result<Rows> rows = read_rows(options.out, subject->study);
  if (!rows) return fail(rows.error());
  const Result<Ended> ended = measure_all(*subject, options, *rows, around);
  if (!ended || *ended == Ended::stopped) return ended;
  if (const Result<void> csv = write_csv(options.out, *rows); !csv) return fail(csv.error());
  if (const Result<void> json = write_rows(options.out, subject->study, *rows, options.seeds); !json) {
    return fail(json.error());
  }
  around.out << tables_of(asked_for(*rows, *subject, options.seeds), options.seeds) << std::flush;
  around.progress << "weft-evaluate: floor.csv and floor.json are in " << options.out.string() << '\n';
  return Ended::complete;
}

}  // namespace weft::evaluate::floor
