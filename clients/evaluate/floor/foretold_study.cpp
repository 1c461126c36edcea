#include "clients/evaluate/floor/foretold_study.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "agents/navigation/config.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/floor/foretold.hpp"
#include "clients/evaluate/table.hpp"

namespace weft::evaluate::floor {
namespace {

using agents::Floor;
constexpr std::array kConditions = {Floor::as_is, Floor::half_light, Floor::worn};
using OfAKind = std::array<std::vector<Compared>, kConditions.size()>;

/// Compares one seed of a kind, and adds it to `all`.
Result<Ended> compare_once(const Stage& stage, const std::string& kind, std::uint64_t seed, OfAKind& all) {
  const Result<Scenario> scenario = Scenario::make(stage, kind, seed);
  if (!scenario) return fail(scenario.error());
  Taught taught;
  const Result<bool> done = teach(scenario->first(), scenario->line(), taught);
  if (!done) return fail(done.error());
  if (!*done) return Ended::stopped;
  for (const Floor::Condition condition : kConditions) {
    auto compared = compare(*scenario, condition, taught, agents::StitchConfig{});
    if (!compared) return fail(compared.error());
    if (!*compared) return Ended::stopped;
    // Of other seeds no metre is the same.
    constexpr double apart_m = 10'000.0;
    for (Compared& place : **compared) place.at_m += apart_m * static_cast<double>(seed);
    std::vector<Compared>& into = all[condition];
    into.insert(into.end(), (*compared)->begin(), (*compared)->end());
  }
  return Ended::complete;
}

std::vector<std::string> heading() {
  std::vector<std::string> row = {"floor", "places"};
  for (const Floor::Condition condition : kConditions) {
    const std::string name(Floor::conditions.at(condition));
    for (const char* const what : {", foretold %", ", found %", ", a metre apart %"}) row.push_back(name + what);
  }
  return row;
}

std::vector<std::string> row_of(const std::string& kind, const OfAKind& all) {
  std::vector<std::string> row = {kind, std::to_string(all.front().size())};
  for (const std::vector<Compared>& compared : all) {
    const Agreement agreement = agreement_of(compared);
    for (const double share : {agreement.foretold, agreement.found, agreement.metre_apart})
      row.push_back(cell(100.0 * share, 0));
  }
  return row;
}

}  // namespace

Result<Ended> study_foretold(const ForetoldOptions& options, const Surroundings& around) {
  Result<Subject> subject = subject_of(options, around.asked_to_stop);
  if (!subject) return fail(subject.error());
  subject->stage.site.floor.contrast = options.contrast;
  std::error_code problem;
  std::filesystem::create_directories(options.out, problem);
  if (problem) return fail(ErrorCode::unavailable, options.out.string() + ": " + problem.message());
  std::vector<std::vector<std::string>> rows = {heading()};
  RowsMeasured progress(subject->kinds.size() * (options.seeds.last - options.seeds.first + 1), 0, around);
  for (const std::string& kind : subject->kinds) {
    OfAKind all;
    for (std::uint64_t seed = options.seeds.first; seed <= options.seeds.last; ++seed) {
      const Result<Ended> ended = compare_once(subject->stage, kind, seed, all);
      if (!ended || *ended == Ended::stopped) return ended;
      progress.row(kind + ", seed " + std::to_string(seed));
    }
    rows.push_back(row_of(kind, all));
  }
  const std::string table = markdown_table(rows, 1);
  around.out << table << std::flush;
  if (const Result<void> written = write_text(options.out / "foretold.md", table); !written)
    return fail(written.error());
  return Ended::complete;
}

}  // namespace weft::evaluate::floor
