#include "clients/evaluate/stereo/rows.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

#include "clients/evaluate/csv.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/study_file.hpp"

namespace weft::evaluate::stereo {
namespace {

using nlohmann::json;

template <class Row>
struct Number {
  const char* name;
  double Row::*value;
};
constexpr Number<PathScore> kPathNumbers[] = {{"ate_m", &PathScore::ate_m},
                                              {"end_m", &PathScore::end_m},
                                              {"step_mm", &PathScore::step_mm},
                                              {"step_deg", &PathScore::step_deg},
                                              {"ms", &PathScore::ms}};
constexpr Number<DenseRow> kDenseNumbers[] = {{"ours_dense", &DenseRow::ours_dense},
                                              {"baseline_dense", &DenseRow::baseline_dense},
                                              {"within_1px", &DenseRow::within_1px},
                                              {"ours_ms", &DenseRow::ours_ms},
                                              {"baseline_ms", &DenseRow::baseline_ms}};

json json_of(const PathScore& score) {
  json made = {{"seen", score.seen}};
  for (const auto& [name, value] : kPathNumbers) made[name] = score.*value;
  return made;
}

PathScore score_from(const json& made) {
  PathScore score;
  score.seen = made.at("seen").get<std::size_t>();
  for (const auto& [name, value] : kPathNumbers) score.*value = number_from(made.at(name));
  return score;
}

json json_of(const RateRow& row) {
  return {{"every", row.every},        {"hz", row.hz},
          {"pairs", row.pairs},        {"way_m", row.way_m},
          {"ours", json_of(row.ours)}, {"baseline", json_of(row.baseline)}};
}

RateRow rate_from(const json& made) {
  RateRow row;
  row.every = made.at("every").get<std::size_t>();
  row.hz = made.at("hz").get<double>();
  row.pairs = made.at("pairs").get<std::size_t>();
  row.way_m = made.at("way_m").get<double>();
  row.ours = score_from(made.at("ours"));
  row.baseline = score_from(made.at("baseline"));
  return row;
}

json json_of(const DenseRow& row) {
  json made = {{"pairs", row.pairs}, {"refused", row.refused}};
  for (const auto& [name, value] : kDenseNumbers) made[name] = row.*value;
  return made;
}

DenseRow dense_from(const json& made) {
  DenseRow row;
  row.pairs = made.at("pairs").get<std::size_t>();
  row.refused = made.at("refused").get<std::size_t>();
  for (const auto& [name, value] : kDenseNumbers) row.*value = number_from(made.at(name));
  return row;
}

json json_of(const Rows& rows) {
  json document = {{"rates", json::array()}, {"dense", rows.dense ? json_of(*rows.dense) : json()}};
  for (const RateRow& row : rows.rates) document["rates"].push_back(json_of(row));
  return document;
}

}  // namespace

const RateRow* Rows::find(std::size_t every) const {
  const auto found = std::find_if(rates.begin(), rates.end(), [&](const RateRow& row) { return row.every == every; });
  return found == rates.end() ? nullptr : &*found;
}

Result<Rows> read_rows(const std::filesystem::path& file, const json& study) {
  Rows rows;
  const Result<void> read = read_rows_of(file, study, "rows", [&](const json& document) {
    for (const json& row : document.at("rates")) rows.rates.push_back(rate_from(row));
    if (!document.at("dense").is_null()) rows.dense = dense_from(document.at("dense"));
  });
  if (!read) return fail(read.error());
  return rows;
}

Result<void> write_rows(const std::filesystem::path& file, const json& study, const Rows& rows) {
  json document = json_of(rows);
  document["study"] = study;
  return write_text(file, document.dump() + "\n");
}

Result<void> write_rows_csv(const std::filesystem::path& file, const Rows& rows) {
  std::vector<std::string> names = {"every", "hz", "method", "pairs", "way_m", "seen"};
  for (const auto& number : kPathNumbers) names.emplace_back(number.name);
  CsvText csv(names);
  for (const RateRow& row : rows.rates) {
    for (const auto& [name, score] : {std::pair{"ours", &row.ours}, {"klt_pnp", &row.baseline}}) {
      csv.value(row.every).number(row.hz).value(name).value(row.pairs).number(row.way_m).value(score->seen);
      for (const auto& number : kPathNumbers) csv.number(score->*number.value);
      csv.end_row();
    }
  }
  return write_text(file, csv.text());
}

}  // namespace weft::evaluate::stereo
