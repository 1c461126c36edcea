#include "clients/evaluate/bearing/rows.hpp"

#include <nlohmann/json.hpp>

#include "clients/evaluate/bearing/bounds.hpp"
#include "clients/evaluate/csv.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/study_file.hpp"

namespace weft::evaluate::bearing {
namespace {

using nlohmann::json;
constexpr const char* kJson = "bearing.json";
constexpr const char* kCsv = "bearing.csv";

json json_of(const Study& study) {
  return {{"software", study.software}, {"scenes_sha256", study.scenes_sha256}};
}

Score score_from(const json& row) {
  Score score;
  score.after_loop_m = row.at("after_loop_m").get<std::vector<double>>();
  score.ended = row.at("ended").get<std::string>();
  score.metres = row.at("metres").get<double>();
  score.landmark_m = number_from(row.at("landmark_m"));
  score.band_m = number_from(row.at("band_m"));
  return score;
}

json json_of(const Judged& judged) {
  const Bound& bound = *judged.bound;
  return {{"name", name_of(bound)}, {"trial", bound.trial},       {"paper", bound.paper},
          {"seeds", judged.seeds},  {"median", judged.median},    {"bound_median", bound.median},
          {"worst", judged.worst},  {"bound_worst", bound.worst}, {"met", judged.met}};
}

}  // namespace

Result<Rows> read_rows(const std::filesystem::path& folder, const Study& study) {
  Rows rows;
  const Result<void> read = read_rows_of(folder / kJson, json_of(study), "rows", [&](const json& document) {
    for (const json& row : document.at("rows"))
      rows.insert_or_assign({row.at("trial").get<std::string>(), row.at("seed").get<std::uint64_t>()},
                            score_from(row));
  });
  if (!read) return fail(read.error());
  return rows;
}

Result<void> write_rows(const std::filesystem::path& folder, const Study& study, const Rows& rows, Seeds seeds) {
  json document = {{"study", json_of(study)}, {"bounds", json::array()}, {"rows", json::array()}};
  for (const Judged& judged : judge(rows, seeds)) document["bounds"].push_back(json_of(judged));
  for (const auto& [key, score] : rows) {
    document["rows"].push_back({{"trial", key.first},
                                {"seed", key.second},
                                {"after_loop_m", score.after_loop_m},
                                {"ended", score.ended},
                                {"metres", score.metres},
                                {"landmark_m", score.landmark_m},  // NaN becomes null
                                {"band_m", score.band_m}});
  }
  return write_text(folder / kJson, document.dump(1) + "\n");
}

Result<void> write_csv(const std::filesystem::path& folder, const Rows& rows) {
  CsvText csv({"trial", "seed", "loop", "error_m"});
  for (const auto& [key, score] : rows) {
    for (std::size_t loop = 0; loop < score.after_loop_m.size(); ++loop)
      csv.words(key.first).value(key.second).value(loop + 1).value(score.after_loop_m[loop]).end_row();
  }
  return write_text(folder / kCsv, csv.text());
}

}  // namespace weft::evaluate::bearing
