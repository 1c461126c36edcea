#include "clients/evaluate/registration/pair_report.hpp"

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "clients/evaluate/registration/trials.hpp"
#include "clients/evaluate/table.hpp"

namespace weft::evaluate::registration {
namespace {

constexpr double kTruthM = 0.02;
constexpr double kTruthDegrees = 0.4;
constexpr double kRivalM = 0.03;

double most_m(bool knows_truth) {
  return knows_truth ? kTruthM : kRivalM;
}

}  // namespace

PairReport compared(const std::vector<Answer>& answers, const std::optional<Pose3>& truth,
                    const std::array<std::size_t, 2>& points) {
  PairReport report{{}, points, truth.has_value(), false};
  const Pose3 right = truth ? *truth : answers[1].a_from_b.value_or(Pose3{});
  for (const Answer& answer : answers) {
    PairReport::Row row{answer};
    if (answer.a_from_b) {
      row.metres = (answer.a_from_b->translation - right.translation).norm();
      row.degrees = kDegrees * answer.a_from_b->rotation.angularDistance(right.rotation);
    }
    report.rows.push_back(row);
  }
  const PairReport::Row& ours = report.rows.front();
  report.is_met = ours.metres <= most_m(report.knows_truth) && (!report.knows_truth || ours.degrees <= kTruthDegrees);
  return report;
}

std::string table_of(const PairReport& report) {
  std::vector<std::vector<std::string>> table = {
      {"way", report.knows_truth ? "off the truth m" : "off PCL GICP m", "degrees", "processor ms", "refused"}};
  for (const auto& [answer, metres, degrees] : report.rows)
    table.push_back({answer.name, cell(metres, 4), cell(degrees, 3), cell(answer.ms, 1), answer.refused});
  std::ostringstream text;
  text << report.points[0] << " and " << report.points[1] << " points\n"
       << markdown_table(table, 1) << (report.is_met ? "met" : "NOT MET") << ": ours within "
       << most_m(report.knows_truth) << " m"
       << (report.knows_truth ? " and 0.4 degrees of the truth\n" : " of PCL GICP\n");
  return text.str();
}

std::string json_of(const PairReport& report) {
  using Json = nlohmann::ordered_json;
  const auto number = [](double value) { return std::isfinite(value) ? Json(value) : Json(); };
  Json rows = Json::array();
  for (const auto& [answer, metres, degrees] : report.rows)
    rows.push_back({{"way", answer.name},
                    {"off_m", number(metres)},
                    {"off_deg", number(degrees)},
                    {"processor_ms", answer.ms},
                    {"refused", answer.refused.empty() ? Json() : Json(answer.refused)}});
  const Json document = {
      {"points", {{"a", report.points[0]}, {"b", report.points[1]}}},
      {"against", report.knows_truth ? "truth" : "PCL GICP"},
      {"rows", rows},
      {"asked",
       {{"off_m", most_m(report.knows_truth)}, {"off_deg", report.knows_truth ? Json(kTruthDegrees) : Json()}}},
      {"is_met", report.is_met}};
  return document.dump() + "\n";
}

}  // namespace weft::evaluate::registration
