#include "clients/evaluate/floor/subject.hpp"

#include <algorithm>
#include <utility>

#include "agents/bodies/sim/changes.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/line.hpp"

namespace weft::evaluate::floor {
namespace {

/// Returns one of the names, or all of them. invalid: names those there are.
Result<std::vector<std::string>> chosen(const std::vector<std::string>& names, const std::string& one,
                                        const std::string& flag) {
  if (one.empty()) return names;
  if (std::find(names.begin(), names.end(), one) != names.end()) return std::vector{one};
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + name;
  return fail(ErrorCode::invalid, flag + ": there is no '" + one + "'; there are " + list);
}

/// Returns what is in a folder of photographs, by name and size.
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

/// Returns the floors to study. invalid: there is no such kind; not_found: no photographs.
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

}  // namespace

Result<Subject> subject_without_line(const FloorOptions& options, std::function<bool()> asked_to_stop) {
  const Result<std::string> site_text = read_text(options.site, "site file; deploy/sites has some");
  if (!site_text) return fail(site_text.error());
  Result<agents::sim::Site> site = agents::sim::parse_site(*site_text, options.site.string());
  if (!site) return fail(site.error());
  Subject subject;
  subject.stage = {std::move(*site), {}, std::nullopt, options.out / "truth.now", std::move(asked_to_stop)};
  subject.study = {WEFT_VERSION, sha256_of(*site_text), "", "", options.metres};
  Result<std::vector<std::string>> kinds = kinds_of(options, subject);
  if (!kinds) return fail(kinds.error());
  Result<std::vector<std::string>> some_lights = options.light.empty() && !options.usual_lights.empty()
                                                     ? options.usual_lights
                                                     : chosen(lights(), options.light, "--light");
  if (!some_lights) return fail(some_lights.error());
  subject.kinds = std::move(*kinds);
  subject.lights = std::move(*some_lights);
  return subject;
}

Result<Subject> subject_of(const FloorOptions& options, std::function<bool()> asked_to_stop) {
  Result<Subject> subject = subject_without_line(options, std::move(asked_to_stop));
  if (!subject) return fail(subject.error());
  const std::filesystem::path along =
      options.along.empty() ? options.site.parent_path() / options.site.stem() / "r1.line" : options.along;
  const Result<std::string> line_text = read_text(along, "line to drive along; give one with --along");
  if (!line_text) return fail(line_text.error());
  const Result<std::vector<agents::SitePoint>> line = parse_line(*line_text, along.string());
  if (!line) return fail(line.error());
  Result<std::vector<agents::SitePoint>> part = first_metres(*line, options.metres, along.string());
  if (!part) return fail(part.error());
  subject->stage.line = std::move(*part);
  subject->study.line_sha256 = sha256_of(*line_text);
  return subject;
}

}  // namespace weft::evaluate::floor
