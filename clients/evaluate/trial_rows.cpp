#include "clients/evaluate/trial_rows.hpp"

#include <nlohmann/json.hpp>

#include "clients/evaluate/csv.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/study_file.hpp"

namespace weft::evaluate {

using nlohmann::json;

json json_of(const TrialRows& rows) {
  json list = json::array();
  for (const auto& [key, score] : rows)
    list.push_back({{"trial", key.first}, {"seed", key.second}, {"values", json(score.values)}});
  return list;
}

TrialRows trial_rows_from(const json& list) {
  TrialRows rows;
  for (const json& row : list) {
    TrialNumbers score;
    for (const auto& [name, value] : row.at("values").items()) score.values[name] = number_from(value);
    rows.insert_or_assign({row.at("trial").get<std::string>(), row.at("seed").get<std::uint64_t>()}, score);
  }
  return rows;
}

Result<void> write_trials_csv(const std::filesystem::path& file, const TrialRows& rows) {
  CsvText csv({"trial", "seed", "number", "value"});
  for (const auto& [key, score] : rows)
    for (const auto& [name, value] : score.values)
      csv.words(key.first).value(key.second).words(name).number(value).end_row();
  return write_text(file, csv.text());
}

}  // namespace weft::evaluate
