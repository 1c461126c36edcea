#include "clients/evaluate/particles/rows.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "clients/evaluate/csv.hpp"
#include "clients/evaluate/files.hpp"
#include "clients/evaluate/study_file.hpp"
#include "clients/evaluate/table.hpp"

namespace weft::evaluate::particles {
namespace {

using nlohmann::json;

/// Names a number of a row; its digits in the table.
struct Column {
  const char* name;
  double TrialRow::*value;
  const char* heading;
  int digits;
};
constexpr Column kColumns[] = {{"mean_m", &TrialRow::mean_m, "mean m", 3},
                               {"p95_m", &TrialRow::p95_m, "95 % m", 3},
                               {"worst_m", &TrialRow::worst_m, "worst m", 3},
                               {"heading_mean_deg", &TrialRow::heading_mean_deg, "heading deg", 2},
                               {"odometry_mean_m", &TrialRow::odometry_mean_m, "odometry alone m", 2},
                               {"particles", &TrialRow::particles, "particles", 0},
                               {"update_ms", &TrialRow::update_ms, "update ms", 2},
                               {"found_after", &TrialRow::found_after, "found after", 0}};

json json_of(const TrialRow& row) {
  json made = {{"seed", row.seed}, {"located", row.located}, {"is_lost", row.is_lost}};
  for (const Column& column : kColumns) {
    const double value = row.*column.value;
    made[column.name] = std::isfinite(value) ? json(value) : json();
  }
  return made;
}

json document_of(const json& study, const std::vector<TrialRow>& rows) {
  json document = {{"study", study}, {"rows", json::array()}};
  for (const TrialRow& row : rows) document["rows"].push_back(json_of(row));
  return document;
}

TrialRow row_from(const json& made) {
  TrialRow row;
  row.seed = made.at("seed").get<std::uint64_t>();
  row.located = made.at("located").get<std::size_t>();
  row.is_lost = made.at("is_lost").get<bool>();
  for (const Column& column : kColumns) row.*column.value = evaluate::number_from(made.at(column.name));
  return row;
}

double mean_over(const std::vector<TrialRow>& rows, double TrialRow::*value) {
  double sum = 0.0;
  for (const TrialRow& row : rows) sum += row.*value;
  return sum / static_cast<double>(rows.size());
}

/// Returns whether nothing is asked, or the value is within it; what is not finite is not.
bool is_within(double value, double asked) {
  return asked <= 0.0 || value <= asked;
}

std::string asked_cell(double asked, int digits) {
  return asked > 0.0 ? "<= " + cell(asked, digits) : "";
}

}  // namespace

Result<std::vector<TrialRow>> read_rows(const std::filesystem::path& file, const json& study) {
  std::vector<TrialRow> rows;
  const Result<void> read = read_rows_of(file, study, "rows", [&](const json& document) {
    for (const json& row : document.at("rows")) rows.push_back(row_from(row));
  });
  if (!read) return fail(read.error());
  return rows;
}

Result<void> write_rows(const std::filesystem::path& file, const json& study, const std::vector<TrialRow>& rows) {
  return write_text(file, document_of(study, rows).dump() + "\n");
}

Result<void> write_rows_csv(const std::filesystem::path& file, const std::vector<TrialRow>& rows) {
  std::vector<std::string> names = {"seed", "located", "is_lost"};
  for (const Column& column : kColumns) names.emplace_back(column.name);
  CsvText csv(names);
  for (const TrialRow& row : rows) {
    csv.value(row.seed).value(row.located).value(row.is_lost ? 1 : 0);
    for (const Column& column : kColumns) csv.number(row.*column.value);
    csv.end_row();
  }
  return write_text(file, csv.text());
}

Asked asked_of(const std::string& log, double alpha, bool is_anywhere) {
  constexpr double nav2_alpha = 0.2;
  if (is_anywhere) return {0.0, 0.0, 40.0};
  if (alpha != nav2_alpha) return {};
  if (log.starts_with("freiburg-079")) return {0.07, 0.16, 0.0};
  if (log.starts_with("intel")) return {0.18, 0.0, 0.0};
  return {};
}

Judged judge(const std::vector<TrialRow>& rows, const Asked& asked, bool is_anywhere) {
  std::vector<std::vector<std::string>> table = {{"seed", "lost", "located"}};
  for (const Column& column : kColumns) table[0].emplace_back(column.heading);
  if (!is_anywhere) table[0].pop_back();
  std::size_t lost = 0;
  bool is_met = !rows.empty();
  for (const TrialRow& row : rows) {
    lost += row.is_lost ? 1U : 0U;
    is_met = is_met && !row.is_lost && is_within(row.found_after, asked.found_after);
    table.push_back({std::to_string(row.seed), row.is_lost ? "LOST" : "no", std::to_string(row.located)});
    for (const Column& column : kColumns) table.back().push_back(cell(row.*column.value, column.digits));
    if (!is_anywhere) table.back().pop_back();
  }
  if (rows.empty()) return {markdown_table(table, 2), false};
  const double mean_m = mean_over(rows, &TrialRow::mean_m);
  const double p95_m = mean_over(rows, &TrialRow::p95_m);
  is_met = is_met && is_within(mean_m, asked.mean_m) && is_within(p95_m, asked.p95_m);
  std::vector<std::string> means(table[0].size());
  means[0] = "mean";
  means[1] = std::to_string(lost);
  for (std::size_t i = 0; i + 3 < means.size(); ++i)
    means[3 + i] = cell(mean_over(rows, kColumns[i].value), kColumns[i].digits);
  table.push_back(means);
  std::vector<std::string> wanted(table[0].size());
  wanted[0] = is_met ? "asked" : "asked: NOT MET";
  wanted[1] = "0";
  wanted[3] = asked_cell(asked.mean_m, 2);
  wanted[4] = asked_cell(asked.p95_m, 2);
  if (is_anywhere) wanted.back() = asked_cell(asked.found_after, 0);
  table.push_back(wanted);
  return {markdown_table(table, 2), is_met};
}

json judged_document(const json& study, const std::vector<TrialRow>& rows, const Asked& asked, bool is_met) {
  const auto bound = [](double most) { return most > 0.0 ? json(most) : json(); };
  json document = document_of(study, rows);
  document["asked"] = {
      {"mean_m", bound(asked.mean_m)}, {"p95_m", bound(asked.p95_m)}, {"found_after", bound(asked.found_after)}};
  document["is_met"] = is_met;
  return document;
}

}  // namespace weft::evaluate::particles
