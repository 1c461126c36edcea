#include "clients/evaluate/ceiling/rows.hpp"

#include <nlohmann/json.hpp>

#include "clients/evaluate/files.hpp"
#include "clients/evaluate/study_file.hpp"
#include "clients/evaluate/trial_rows.hpp"

namespace weft::evaluate::ceiling {
namespace {

using nlohmann::json;
constexpr const char* kCeilingJson = "ceiling.json";
constexpr const char* kCeilingCsv = "ceiling.csv";

json json_of(const Judged& judged) {
  const Bound& bound = *judged.bound;
  return {{"row", bound.row},
          {"measure", bound.measure},
          {"unit", bound.unit},
          {"trial", bound.trial},
          {"values", bound.values},
          {"is_at_most", bound.sense == Bound::Sense::at_most},
          {"bound_median", bound.median},
          {"bound_worst", bound.worst},  // NaN becomes null
          {"seeds", judged.seeds},
          {"median", judged.median},
          {"worst", judged.worst},
          {"baseline", judged.baseline},
          {"verdict", to_string(judged.verdict)}};
}

}  // namespace

json json_of(const Study& study) {
  return {{"software", study.software},    {"scenes_sha256", study.scenes_sha256}, {"recording", study.recording},
          {"metres", study.extent.metres}, {"put_downs", study.extent.put_downs},  {"quick", study.extent.is_quick}};
}

Result<Rows> read_rows(const std::filesystem::path& folder, const Study& study) {
  Rows rows;
  const Result<void> read = read_rows_of(folder / kCeilingJson, ceiling::json_of(study), "rows",
                                         [&](const json& document) { rows = trial_rows_from(document.at("rows")); });
  if (!read) return fail(read.error());
  return rows;
}

Result<void> write_rows(const std::filesystem::path& folder, const Study& study, const Rows& rows,
                        const std::vector<Judged>& all) {
  json document = {{"study", ceiling::json_of(study)}, {"bounds", json::array()}, {"rows", evaluate::json_of(rows)}};
  for (const Judged& judged : all) document["bounds"].push_back(json_of(judged));
  return write_text(folder / kCeilingJson, document.dump(1) + "\n");
}

Result<void> write_csv(const std::filesystem::path& folder, const Rows& rows) {
  return write_trials_csv(folder / kCeilingCsv, rows);
}

Result<void> write_shown(const std::filesystem::path& folder, const std::string& trial, const Shown& shown) {
  return write_series(folder, trial, json(shown));
}

}  // namespace weft::evaluate::ceiling
