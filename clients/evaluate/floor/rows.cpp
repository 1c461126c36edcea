#include "clients/evaluate/floor/rows.hpp"

#include <nlohmann/json.hpp>
#include <utility>

#include "clients/evaluate/csv.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/study_file.hpp"

namespace weft::evaluate::floor {
namespace {

using nlohmann::json;
constexpr const char* kJson = "floor.json";
constexpr const char* kCsv = "floor.csv";

Score score_from(const json& row) {
  Score score;
  for (const Column& column : columns()) score.*column.value = number_from(row.at(column.name));
  score.blind_distances_m = row.at("blind_distances_m").get<std::vector<double>>();
  score.refusals = row.at("refusals").get<std::map<std::string, std::uint64_t>>();
  return score;
}

json json_of(const Judged& judged) {
  const Bound& bound = *judged.bound;
  json row = {{"name", bound.name},
              {"unit", bound.unit},
              {"paper", bound.paper},
              {"median", judged.median},
              {"bound_median", bound.median},
              {"worst", judged.worst},
              {"bound_worst", bound.worst},
              {"met", judged.met},
              {"judged", judged.is_judged},
              {"groups", json::array()},
              {"command", std::string("weft-evaluate ") + judged.command}};
  if (judged.of) row["of"] = *judged.of;
  for (const Group& group : judged.groups) {
    row["groups"].push_back({{"floor", group.kind},
                             {"part", group.part},
                             {"seeds", group.seeds},
                             {"metres", group.metres},
                             {"median", group.median},
                             {"worst", group.worst},
                             {"met", group.met}});
  }
  return row;
}

}  // namespace

Result<Rows> read_rows(const std::filesystem::path& folder, const Study& study) {
  Rows rows;
  const Result<void> read = read_rows_of(folder / kJson, json_of(study), "rows", [&](const json& document) {
    for (const json& row : document.at("rows")) {
      rows.insert_or_assign(RowKey{row.at("floor").get<std::string>(), row.at("part").get<std::string>(),
                                   row.at("seed").get<std::uint64_t>()},
                            score_from(row));
    }
  });
  if (!read) return fail(read.error());
  return rows;
}

Result<void> write_rows(const std::filesystem::path& folder, const Study& study, const Rows& rows,
                        const std::vector<Judged>& promises) {
  json document = {{"study", json_of(study)}, {"bounds", json::array()}, {"rows", json::array()}};
  for (const Judged& judged : promises) document["bounds"].push_back(json_of(judged));
  for (const auto& [key, score] : rows) {
    json row = {{"floor", key.kind}, {"part", key.part}, {"seed", key.seed}};
    for (const Column& column : columns()) row[column.name] = score.*column.value;  // NaN becomes null
    row["blind_distances_m"] = score.blind_distances_m;
    row["refusals"] = score.refusals;
    document["rows"].push_back(row);
  }
  return write_text(folder / kJson, document.dump(1) + "\n");
}

Result<void> write_csv(const std::filesystem::path& folder, const Rows& rows) {
  std::vector<std::string> names = {"floor", "part", "seed"};
  for (const Column& column : columns()) names.emplace_back(column.name);
  names.emplace_back("refusals");
  CsvText csv(names);
  for (const auto& [key, score] : rows) {
    csv.words(key.kind).words(key.part).value(key.seed);
    for (const Column& column : columns()) csv.number(score.*column.value);
    std::string refusals;
    for (const char* between = ""; const auto& [reason, times] : score.refusals)
      refusals += std::exchange(between, "; ") + reason + ' ' + std::to_string(times);
    csv.words(refusals).end_row();
  }
  return write_text(folder / kCsv, csv.text());
}

json json_of(const Study& study) {
  return {{"software", study.software},
          {"site_sha256", study.site_sha256},
          {"line_sha256", study.line_sha256},
          {"floors_sha256", study.floors_sha256},
          {"metres", study.metres}};
}

Study study_from(const json& study) {
  return {study.at("software").get<std::string>(), study.at("site_sha256").get<std::string>(),
          study.at("line_sha256").get<std::string>(), study.at("floors_sha256").get<std::string>(),
          study.at("metres").get<double>()};
}

std::string stamp_of(const Study& study) {
  return sha256_of(json_of(study).dump()).substr(0, 16);
}

}  // namespace weft::evaluate::floor
