#include "clients/evaluate/registration/rooms_report.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "agents/perception/robust.hpp"
#include "clients/evaluate/table.hpp"

namespace weft::evaluate::registration {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kGrownM = 0.01;

/// Bounds row E1: of the median over seeds, and of the worst.
struct EdgeBounds {
  double across;
  double along;
  double grown;
};
constexpr EdgeBounds kMedian{0.8, 1.05, 0.03};
constexpr EdgeBounds kWorst{1.0, 1.1, 0.06};

/// Holds the median and the largest of some values, or what bounds them.
struct MedianWorst {
  double median = std::numeric_limits<double>::quiet_NaN();
  double worst = std::numeric_limits<double>::quiet_NaN();
};
constexpr MedianWorst kStitchM{0.04, 0.08};
constexpr MedianWorst kStitchDegrees{0.5, 1.0};

/// Returns median and largest; NaN without values.
MedianWorst median_and_worst(const std::vector<double>& values) {
  if (values.empty()) return {};
  return {agents::median_of(values), *std::max_element(values.begin(), values.end())};
}

double ratio(const std::vector<Trial>& trials, double Off::*of) {
  std::vector<double> before;
  std::vector<double> after;
  for (const Trial& trial : trials) {
    before.push_back(trial.before.*of);
    after.push_back(trial.after.*of);
  }
  return agents::median_of(after) / agents::median_of(before);
}

bool is_within(const EdgeSummary& summary, const EdgeBounds& bounds) {
  return summary.across_ratio <= bounds.across && summary.along_ratio <= bounds.along &&
         summary.grown_share <= bounds.grown;
}

bool is_within(const MedianWorst& both, const MedianWorst& bounds) {
  return both.median <= bounds.median && both.worst <= bounds.worst;
}

bool is_within(const Stitches& stitches) {
  return stitches.metres.empty() || (is_within(median_and_worst(stitches.metres), kStitchM) &&
                                     is_within(median_and_worst(stitches.degrees), kStitchDegrees));
}

std::string pair_of(const MedianWorst& both, int digits) {
  return cell(both.median, digits) + " / " + cell(both.worst, digits);
}

std::vector<std::string> edge_cells(const RoomsReport::Row& row) {
  const auto& [median, worst] = row.edges;
  return {std::string(row.scene),
          std::to_string(median.edges),
          std::to_string(median.refused),
          pair_of({median.across_ratio, worst.across_ratio}, 2),
          pair_of({median.along_ratio, worst.along_ratio}, 2),
          pair_of({median.heading_ratio, worst.heading_ratio}, 2),
          pair_of({median.grown_share, worst.grown_share}, 3),
          pair_of({median.mean_nees, worst.mean_nees}, 1)};
}

std::vector<std::string> stitch_cells(const RoomsReport::Row& row) {
  const Stitches& stitches = row.stitches;
  std::string reasons;
  for (const auto& [reason, times] : stitches.refused) reasons += reason + " " + std::to_string(times) + " ";
  return {std::string(row.scene),
          std::to_string(stitches.all),
          std::to_string(stitches.metres.size()),
          pair_of(median_and_worst(stitches.metres), 3),
          pair_of(median_and_worst(stitches.degrees), 2),
          reasons};
}

Json json_of_both(const MedianWorst& both) {
  const auto number = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
  return {{"median", number(both.median)}, {"worst", number(both.worst)}};
}

Json edges_json(const RoomsReport::Row& row) {
  const auto& [median, worst] = row.edges;
  return {{"scene", row.scene},
          {"edges", median.edges},
          {"refused", median.refused},
          {"across_ratio", json_of_both({median.across_ratio, worst.across_ratio})},
          {"along_ratio", json_of_both({median.along_ratio, worst.along_ratio})},
          {"heading_ratio", json_of_both({median.heading_ratio, worst.heading_ratio})},
          {"grown_share", json_of_both({median.grown_share, worst.grown_share})},
          {"mean_nees", json_of_both({median.mean_nees, worst.mean_nees})}};
}

Json stitches_json(const RoomsReport::Row& row) {
  const Stitches& stitches = row.stitches;
  return {{"scene", row.scene},
          {"stitches", stitches.all},
          {"joined", stitches.metres.size()},
          {"off_m", json_of_both(median_and_worst(stitches.metres))},
          {"off_deg", json_of_both(median_and_worst(stitches.degrees))},
          {"refused", stitches.refused}};
}

}  // namespace

EdgeSummary summary_of(const std::vector<Trial>& trials) {
  EdgeSummary summary;
  if (trials.empty()) return summary;
  summary.edges = trials.size();
  summary.along_ratio = ratio(trials, &Off::along_m);
  summary.across_ratio = ratio(trials, &Off::across_m);
  summary.heading_ratio = ratio(trials, &Off::heading_rad);
  double grown = 0.0;
  double nees = 0.0;
  for (const Trial& trial : trials) {
    grown += trial.after.metres() > trial.before.metres() + kGrownM ? 1.0 : 0.0;
    summary.refused += trial.refused.empty() ? 0U : 1U;
    nees += trial.nees;
  }
  summary.grown_share = grown / static_cast<double>(trials.size());
  summary.mean_nees = nees / std::max(1.0, static_cast<double>(trials.size() - summary.refused));
  return summary;
}

EdgeRow over_seeds(const std::vector<EdgeSummary>& seeds) {
  EdgeRow row;
  for (const auto of : {&EdgeSummary::along_ratio, &EdgeSummary::across_ratio, &EdgeSummary::heading_ratio,
                        &EdgeSummary::grown_share, &EdgeSummary::mean_nees}) {
    std::vector<double> values;
    for (const EdgeSummary& summary : seeds) values.push_back(summary.*of);
    const auto both = median_and_worst(values);
    row.median.*of = both.median;
    row.worst.*of = both.worst;
  }
  for (const EdgeSummary& summary : seeds) {
    row.median.edges += summary.edges;
    row.median.refused += summary.refused;
  }
  return row;
}

void Stitches::add(const std::vector<Trial>& trials) {
  for (const Trial& trial : trials) {
    ++all;
    if (!trial.refused.empty()) {
      ++refused[trial.refused];
      continue;
    }
    metres.push_back(trial.after.metres());
    degrees.push_back(kDegrees * trial.after.heading_rad);
  }
}

bool RoomsReport::is_met() const {
  return std::all_of(rows.begin(), rows.end(), [](const Row& row) {
    return is_within(row.edges.median, kMedian) && is_within(row.edges.worst, kWorst) && is_within(row.stitches);
  });
}

std::string tables_of(const RoomsReport& report) {
  std::vector<std::vector<std::string>> edges = {
      {"scene", "edges", "refused", "across after / before", "along", "heading", "grew by > 1 cm", "NEES (6)"}};
  std::vector<std::vector<std::string>> stitches = {
      {"scene", "stitches", "joined", "off m", "off degrees", "refused"}};
  for (const RoomsReport::Row& row : report.rows) {
    edges.push_back(edge_cells(row));
    stitches.push_back(stitch_cells(row));
  }
  return "Edges with their prior, median / worst seed\n" + markdown_table(edges, 1) +
         "\nStitches from a guess, median / worst of all\n" + markdown_table(stitches, 1) +
         (report.is_met() ? "met" : "NOT MET") +
         ": row E1 (edges: across <= 0.8 / 1, along <= 1.05 / 1.1, grew <= 0.03 / 0.06; stitches: 0.04 / 0.08 m, "
         "0.5 / 1 degree)\n";
}

std::string json_of(const RoomsReport& report) {
  Json document = {{"edges", Json::array()}, {"stitches", Json::array()}};
  for (const RoomsReport::Row& row : report.rows) {
    document["edges"].push_back(edges_json(row));
    document["stitches"].push_back(stitches_json(row));
  }
  document["asked"] = {{"across_ratio", json_of_both({kMedian.across, kWorst.across})},
                       {"along_ratio", json_of_both({kMedian.along, kWorst.along})},
                       {"grown_share", json_of_both({kMedian.grown, kWorst.grown})},
                       {"off_m", json_of_both(kStitchM)},
                       {"off_deg", json_of_both(kStitchDegrees)}};
  document["is_met"] = report.is_met();
  return document.dump() + "\n";
}

}  // namespace weft::evaluate::registration
