#include <nlohmann/json.hpp>

#include "clients/evaluate/stereo/rows.hpp"
#include "clients/evaluate/table.hpp"

namespace weft::evaluate::stereo {
namespace {

/// Says in a cell what is asked, and whether it holds.
std::string verdict(double value, double most, int digits) {
  return "<= " + cell(most, digits) + (value <= most ? "" : " NOT MET");
}

bool is_met(const RateRow& row, const Asked& asked) {
  return row.ours.ate_m <= row.baseline.ate_m && (asked.ate_m <= 0.0 || row.ours.ate_m <= asked.ate_m) &&
         (asked.ms <= 0.0 || row.ours.ms <= asked.ms);
}

std::vector<std::string> cells_of(const RateRow& row, const std::string& method, const PathScore& score) {
  return {cell(row.hz, 0),
          method,
          std::to_string(row.pairs),
          std::to_string(score.seen),
          cell(score.ate_m, 4),
          "",
          cell(score.end_m, 4),
          cell(score.step_mm, 2),
          cell(score.step_deg, 3),
          cell(score.ms, 1),
          ""};
}

std::string table_of_rates(const std::string& recording, const Rows& rows) {
  std::vector<std::vector<std::string>> table = {{"Hz", "method", "pairs", "steps seen", "ATE m", "asked",
                                                  "end off m", "step mm", "step deg", "ms", "asked ms"}};
  for (const RateRow& row : rows.rates) {
    const Asked asked = asked_of(recording, row);
    std::vector<std::string> ours = cells_of(row, "ours", row.ours);
    const bool is_bounded = asked.ate_m > 0.0 && asked.ate_m < row.baseline.ate_m;
    ours[5] = is_bounded ? verdict(row.ours.ate_m, asked.ate_m, 4)
                         : verdict(row.ours.ate_m, row.baseline.ate_m, 4) + " (KLT + PnP)";
    if (asked.ms > 0.0) ours[10] = verdict(row.ours.ms, asked.ms, 0);
    table.push_back(ours);
    table.push_back(cells_of(row, "KLT + PnP", row.baseline));
  }
  return markdown_table(table, 2);
}

std::string table_of_dense(const DenseRow& row) {
  const auto percent = [](double share) { return cell(100.0 * share, 1); };
  return markdown_table(
      {{"dense disparity", "pairs", "refused", "dense %", "within 1 px of SGBM %", "ms"},
       {"ours", std::to_string(row.pairs), std::to_string(row.refused), percent(row.ours_dense),
        percent(row.within_1px), cell(row.ours_ms, 1)},
       {"SGBM", std::to_string(row.pairs), "", percent(row.baseline_dense), "", cell(row.baseline_ms, 1)}},
      1);
}

nlohmann::ordered_json document_of(const PathScore& score) {
  return {{"seen", score.seen},       {"ate_m", score.ate_m},       {"end_m", score.end_m},
          {"step_mm", score.step_mm}, {"step_deg", score.step_deg}, {"ms", score.ms}};
}

nlohmann::ordered_json document_of(const RateRow& row, const Asked& asked) {
  const auto bound = [](double most) { return most > 0.0 ? nlohmann::ordered_json(most) : nlohmann::ordered_json(); };
  return {{"every", row.every},
          {"hz", row.hz},
          {"pairs", row.pairs},
          {"way_m", row.way_m},
          {"ours", document_of(row.ours)},
          {"klt_pnp", document_of(row.baseline)},
          {"asked_ate_m", bound(asked.ate_m)},
          {"asked_ms", bound(asked.ms)},
          {"met", is_met(row, asked)}};
}

}  // namespace

Asked asked_of(const std::string& recording, const RateRow& row) {
  constexpr double rest_m = 0.001;
  if (row.is_at_rest()) return {rest_m, 0.0};
  if (recording.starts_with("euroc-mh01")) {
    if (row.every == 1 || row.every == 2) return {0.007, 0.0};
    if (row.every == 4) return {0.012, 0.0};
  }
  if (recording == "KITTI_sequence_1" && row.every == 1) return {0.12, 8.0};
  return {};
}

Judged judge(const std::string& recording, const Rows& rows) {
  Judged judged;
  judged.is_met = !rows.rates.empty();
  nlohmann::ordered_json document = {{"recording", recording}, {"rates", nlohmann::ordered_json::array()}};
  for (const RateRow& row : rows.rates) {
    const Asked asked = asked_of(recording, row);
    judged.is_met = judged.is_met && is_met(row, asked);
    document["rates"].push_back(document_of(row, asked));
  }
  judged.table = table_of_rates(recording, rows);
  if (rows.dense) {
    judged.table += "\n" + table_of_dense(*rows.dense);
    document["dense"] = {{"pairs", rows.dense->pairs},
                         {"refused", rows.dense->refused},
                         {"ours_dense", rows.dense->ours_dense},
                         {"sgbm_dense", rows.dense->baseline_dense},
                         {"within_1px_of_sgbm", rows.dense->within_1px},
                         {"ours_ms", rows.dense->ours_ms},
                         {"sgbm_ms", rows.dense->baseline_ms}};
  }
  document["met"] = judged.is_met;
  judged.json = document.dump() + "\n";
  return judged;
}

}  // namespace weft::evaluate::stereo
