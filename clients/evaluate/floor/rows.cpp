#include "clients/evaluate/floor/rows.hpp"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <utility>

#include "clients/evaluate/files.hpp"

namespace weft::evaluate::floor {
namespace {

using nlohmann::json;
constexpr const char* kJson = "floor.json";
constexpr const char* kCsv = "floor.csv";

Score score_from(const json& row) {
  Score score;
  for (const Column& column : columns()) {
    const json& number = row.at(column.name);
    score.*column.value = number.is_null() ? Score::kNothing : number.get<double>();
  }
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
  const std::filesystem::path file = folder / kJson;
  std::ifstream in(file, std::ios::binary);
  if (!in) return Rows{};
  Rows rows;
  try {
    const json document = json::parse(in);
    const std::string differs = difference(document.at("study"), json_of(study));
    if (!differs.empty()) {
      return fail(ErrorCode::conflict, file.string() + ": holds the rows of another study (other " + differs +
                                           "); give another --out, or remove the file");
    }
    for (const json& row : document.at("rows")) {
      rows.insert_or_assign(RowKey{row.at("floor").get<std::string>(), row.at("part").get<std::string>(),
                                   row.at("seed").get<std::uint64_t>()},
                            score_from(row));
    }
  } catch (const json::exception& problem) {
    return fail(ErrorCode::corrupt, file.string() + ": not what weft-evaluate wrote (" + problem.what() +
                                        "); give another --out, or remove the file");
  }
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
  std::ostringstream text;
  text << "floor,part,seed";
  for (const Column& column : columns()) text << ',' << column.name;
  text << ",refusals\n";
  for (const auto& [key, score] : rows) {
    text << '"' << key.kind << "\",\"" << key.part << "\"," << key.seed;
    for (const Column& column : columns()) {
      text << ',';
      if (std::isfinite(score.*column.value)) text << score.*column.value;
    }
    text << ",\"";
    for (const char* between = ""; const auto& [reason, times] : score.refusals)
      text << std::exchange(between, "; ") << reason << ' ' << times;
    text << "\"\n";
  }
  return write_text(folder / kCsv, text.str());
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
