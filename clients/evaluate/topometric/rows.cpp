#include "clients/evaluate/topometric/rows.hpp"

#include <nlohmann/json.hpp>

#include "clients/evaluate/files.hpp"
#include "clients/evaluate/study_file.hpp"
#include "clients/evaluate/trial_rows.hpp"

namespace weft::evaluate::topometric {
namespace {

using nlohmann::json;
constexpr const char* kTopometricJson = "topometric.json";
constexpr const char* kTopometricCsv = "topometric.csv";

json json_of_study(const Study& study) {
  return {{"software", study.software},
          {"scenes_sha256", study.scenes_sha256},
          {"width_px", study.extent.width_px},
          {"quick", study.extent.is_quick}};
}

const char* name_of(Bound::Sense sense) {
  switch (sense) {
    case Bound::Sense::at_most:
      return "at_most";
    case Bound::Sense::at_least:
      return "at_least";
    case Bound::Sense::mean_at_least:
      return "mean_at_least";
    case Bound::Sense::between:
      break;
  }
  return "between";
}

json json_of_judged(const Judged& judged) {
  const Bound& bound = *judged.bound;
  return {{"row", bound.row},
          {"measure", bound.measure},
          {"unit", bound.unit},
          {"paper", bound.paper},
          {"trial", bound.trial},
          {"value", bound.value},
          {"sense", name_of(bound.sense)},
          {"bound_median", bound.median},
          {"bound_worst", bound.worst},  // NaN becomes null
          {"seeds", judged.seeds},
          {"median", judged.median},
          {"worst", judged.worst},
          {"verdict", to_string(judged.verdict)}};
}

}  // namespace

json document_of(const Study& study, const Rows& rows, const std::vector<Judged>& all) {
  json document = {{"study", json_of_study(study)}, {"bounds", json::array()}, {"rows", evaluate::json_of(rows)}};
  for (const Judged& judged : all) document["bounds"].push_back(json_of_judged(judged));
  return document;
}

Result<Rows> read_rows(const std::filesystem::path& folder, const Study& study) {
  Rows rows;
  const Result<void> read = read_rows_of(folder / kTopometricJson, json_of_study(study), "rows",
                                         [&](const json& document) { rows = trial_rows_from(document.at("rows")); });
  if (!read) return fail(read.error());
  return rows;
}

Result<void> write_rows(const std::filesystem::path& folder, const Study& study, const Rows& rows,
                        const std::vector<Judged>& all) {
  return write_text(folder / kTopometricJson, document_of(study, rows, all).dump(1) + "\n");
}

Result<void> write_csv(const std::filesystem::path& folder, const Rows& rows) {
  return write_trials_csv(folder / kTopometricCsv, rows);
}

Result<void> write_shown(const std::filesystem::path& folder, const std::string& trial, const Shown& shown) {
  return write_series(folder, trial, json(shown));
}

}  // namespace weft::evaluate::topometric
