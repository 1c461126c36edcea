#include "clients/evaluate/ceiling/rows.hpp"

#include <nlohmann/json.hpp>

#include "clients/evaluate/csv.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/study_file.hpp"

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
  const Result<void> read =
      read_rows_of(folder / kCeilingJson, ceiling::json_of(study), "rows", [&](const json& document) {
        for (const json& row : document.at("rows")) {
          Score score;
          for (const auto& [name, value] : row.at("values").items()) score.values[name] = number_from(value);
          rows.insert_or_assign({row.at("trial").get<std::string>(), row.at("seed").get<std::uint64_t>()}, score);
        }
      });
  if (!read) return fail(read.error());
  return rows;
}

Result<void> write_rows(const std::filesystem::path& folder, const Study& study, const Rows& rows,
                        const std::vector<Judged>& all) {
  json document = {{"study", ceiling::json_of(study)}, {"bounds", json::array()}, {"rows", json::array()}};
  for (const Judged& judged : all) document["bounds"].push_back(json_of(judged));
  for (const auto& [key, score] : rows)
    document["rows"].push_back({{"trial", key.first}, {"seed", key.second}, {"values", json(score.values)}});
  return write_text(folder / kCeilingJson, document.dump(1) + "\n");
}

Result<void> write_csv(const std::filesystem::path& folder, const Rows& rows) {
  CsvText csv({"trial", "seed", "number", "value"});
  for (const auto& [key, score] : rows)
    for (const auto& [name, value] : score.values)
      csv.words(key.first).value(key.second).words(name).number(value).end_row();
  return write_text(folder / kCeilingCsv, csv.text());
}

Result<void> write_shown(const std::filesystem::path& folder, const std::string& trial, const Shown& shown) {
  return write_series(folder, trial, json(shown));
}

}  // namespace weft::evaluate::ceiling
