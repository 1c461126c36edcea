#include "clients/evaluate/bearing/rows.hpp"

#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "clients/evaluate/bearing/bounds.hpp"
#include "clients/evaluate/files.hpp"

namespace weft::evaluate::bearing {
namespace {

using nlohmann::json;
constexpr const char* kJson = "bearing.json";
constexpr const char* kCsv = "bearing.csv";

json json_of(const Study& study) {
  return {{"software", study.software}, {"scenes_sha256", study.scenes_sha256}};
}

double number_from(const json& number) {
  return number.is_null() ? Score::kNothing : number.get<double>();
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
    for (const json& row : document.at("rows"))
      rows.insert_or_assign({row.at("trial").get<std::string>(), row.at("seed").get<std::uint64_t>()},
                            score_from(row));
  } catch (const json::exception& problem) {
    return fail(ErrorCode::corrupt, file.string() + ": not what weft-evaluate wrote (" + problem.what() +
                                        "); give another --out, or remove the file");
  }
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
  std::ostringstream text;
  text << "trial,seed,loop,error_m\n";
  for (const auto& [key, score] : rows) {
    for (std::size_t loop = 0; loop < score.after_loop_m.size(); ++loop)
      text << '"' << key.first << "\"," << key.second << ',' << loop + 1 << ',' << score.after_loop_m[loop] << '\n';
  }
  return write_text(folder / kCsv, text.str());
}

}  // namespace weft::evaluate::bearing
