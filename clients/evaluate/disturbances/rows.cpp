#include "clients/evaluate/disturbances/rows.hpp"

#include <cstdint>
#include <nlohmann/json.hpp>

#include "clients/evaluate/csv.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/study_file.hpp"

namespace weft::evaluate {
namespace {

using nlohmann::json;
constexpr const char* kJson = "disturbances.json";
constexpr const char* kCsv = "disturbances.csv";

json json_of(const Study& study) {
  return {{"software", study.software},
          {"site_sha256", study.site_sha256},
          {"line_sha256", study.line_sha256},
          {"metres", study.metres}};
}

Score score_of(const json& row) {
  Score score;
  for (const Column& column : columns()) score.*column.value = number_from(row.at(column.name));
  return score;
}

}  // namespace

const std::vector<Column>& columns() {
  static const std::vector<Column> all = {
      {"speed_error_mm_s", "speed mm/s", &Score::speed_error_mm_s, 1},
      {"drift_mm", "drift mm", &Score::drift_mm, 0},
      {"drift_deg", "drift deg", &Score::drift_deg, 2},
      {"fix_mm", "fix mm", &Score::fix_mm, 1},
      {"fix_95_mm", "fix 95 % mm", &Score::fix_95_mm, 1},
      {"fix_deg", "fix deg", &Score::fix_deg, 2},
      {"fixes_percent", "fixes %", &Score::fixes_percent, 1},
      {"wrong_fixes", "wrong", &Score::wrong_fixes, 1},
      {"blind_percent", "blind %", &Score::blind_percent, 2},
  };
  return all;
}

Result<Rows> read_rows(const std::filesystem::path& folder, const Study& study) {
  Rows rows;
  const Result<void> read = read_rows_of(folder / kJson, json_of(study), "rows", [&](const json& document) {
    for (const json& row : document.at("rows")) {
      rows.insert_or_assign({row.at("variant").get<std::string>(), row.at("seed").get<std::uint64_t>()},
                            score_of(row));
    }
  });
  if (!read) return fail(read.error());
  return rows;
}

Result<void> write_rows(const std::filesystem::path& folder, const Study& study, const Rows& rows) {
  json document = {{"study", json_of(study)}, {"rows", json::array()}};
  for (const auto& [key, score] : rows) {
    json row = {{"variant", key.first}, {"seed", key.second}};
    for (const Column& column : columns()) row[column.name] = score.*column.value;  // NaN becomes null
    document["rows"].push_back(row);
  }
  return write_text(folder / kJson, document.dump(1) + "\n");
}

Result<void> write_csv(const std::filesystem::path& folder, const std::vector<std::string>& variants,
                       const Rows& rows) {
  std::vector<std::string> names = {"variant", "seed"};
  for (const Column& column : columns()) names.emplace_back(column.name);
  CsvText csv(names);
  for (const std::string& variant : variants) {
    for (auto at = rows.lower_bound({variant, 0}); at != rows.end() && at->first.first == variant; ++at) {
      csv.words(variant).value(at->first.second);
      for (const Column& column : columns()) csv.number(at->second.*column.value);
      csv.end_row();
    }
  }
  return write_text(folder / kCsv, csv.text());
}

}  // namespace weft::evaluate
