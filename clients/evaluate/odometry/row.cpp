#include "clients/evaluate/odometry/row.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "clients/evaluate/csv.hpp"
#include "clients/evaluate/floor/bounds.hpp"
#include "clients/evaluate/floor/measures.hpp"
#include "clients/evaluate/table.hpp"

namespace weft::evaluate::odometry {
namespace {

constexpr double kDriftM = 1.0;

/// Returns by how much stretches are off at their end, RMS: metres and radians.
std::pair<double, double> drift_of(const floor::Trace& trace) {
  const std::vector<floor::Stretch> stretches = floor::stretches(trace, kDriftM);
  double metres2 = 0.0;
  double radians2 = 0.0;
  for (const floor::Stretch& stretch : stretches) {
    metres2 += stretch.off.head<2>().squaredNorm();
    radians2 += stretch.off.z() * stretch.off.z();
  }
  if (stretches.empty()) return {floor::Score::kNothing, floor::Score::kNothing};
  const auto count = static_cast<double>(stretches.size());
  return {std::sqrt(metres2 / count), std::sqrt(radians2 / count)};
}

double blind_percent_of(const floor::Trace& trace) {
  const auto blind = std::count_if(trace.moments.begin() + 1, trace.moments.end(),
                                   [](const floor::Moment& moment) { return !moment.seen; });
  return 100.0 * static_cast<double>(blind) / static_cast<double>(trace.moments.size() - 1);
}

/// Returns all values of the rows in one list.
std::vector<double> joined(const std::vector<const Row*>& rows, std::vector<double> Row::*values) {
  std::vector<double> all;
  for (const Row* const row : rows) all.insert(all.end(), (row->*values).begin(), (row->*values).end());
  return all;
}

std::vector<double> each(const std::vector<const Row*>& rows, double Row::*value) {
  std::vector<double> all;
  for (const Row* const row : rows) all.push_back(row->*value);
  return all;
}

std::vector<std::string> line_of(const std::string& kind, const std::vector<const Row*>& rows) {
  const floor::MedianWorst speed = floor::median_worst(each(rows, &Row::speed_percent));
  const auto middle = [&](double Row::*value) { return floor::median_worst(each(rows, value)).median; };
  return {rows.front()->drive,
          rows.front()->observer,
          kind,
          cell(static_cast<double>(rows.size()), 0),
          cell(speed.median, 2),
          cell(speed.worst, 2),
          cell(middle(&Row::drift_mm), 2),
          cell(middle(&Row::drift_deg), 3),
          cell(middle(&Row::blind_percent), 1),
          cell(floor::held_percent(joined(rows, &Row::over_1m)), 1),
          cell(floor::held_percent(joined(rows, &Row::over_10m)), 1),
          cell(middle(&Row::ms_a_view), 2)};
}

}  // namespace

Row row_of(const std::string& kind, std::uint64_t seed, const std::string& drive, const Observer& observer) {
  const floor::Trace& trace = observer.trace();
  const auto [metres, radians] = drift_of(trace);
  return {kind,
          seed,
          drive,
          observer.name(),
          floor::speed_error(trace).percent,
          1e3 * metres,
          180.0 / std::numbers::pi * radians,
          blind_percent_of(trace),
          observer.ms_a_view(),
          floor::distances2(floor::stretches(trace, 1.0)),
          floor::distances2(floor::stretches(trace, 10.0))};
}

std::string csv_of(const std::vector<Row>& rows) {
  CsvText csv({"floor", "seed", "drive", "observer", "speed_percent", "drift_mm", "drift_deg", "blind_percent",
               "held_1m_percent", "held_10m_percent", "ms_a_view"});
  for (const Row& row : rows) {
    csv.words(row.kind).value(row.seed).words(row.drive).words(row.observer);
    for (const double value : {row.speed_percent, row.drift_mm, row.drift_deg, row.blind_percent,
                               floor::held_percent(row.over_1m), floor::held_percent(row.over_10m), row.ms_a_view})
      csv.number(value);
    csv.end_row();
  }
  return csv.text();
}

std::string table_of(const std::vector<Row>& rows) {
  std::vector<std::vector<std::string>> lines = {{"drive", "observer", "floor", "runs", "speed %", "worst", "mm a m",
                                                  "deg a m", "blind %", "held 1 m %", "held 10 m %", "ms a view"}};
  std::vector<std::pair<std::string, std::string>> groups;  // drive, observer; in order of appearance
  for (const Row& row : rows) {
    const std::pair group{row.drive, row.observer};
    if (std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
  }
  for (const auto& [drive, observer] : groups) {
    std::vector<const Row*> all;
    std::vector<std::pair<std::string, std::vector<const Row*>>> kinds;
    for (const Row& row : rows) {
      if (row.drive != drive || row.observer != observer) continue;
      all.push_back(&row);
      const auto known = std::find_if(kinds.begin(), kinds.end(), [&](const auto& k) { return k.first == row.kind; });
      if (known != kinds.end()) known->second.push_back(&row);
      if (known == kinds.end()) kinds.push_back({row.kind, {&row}});
    }
    lines.push_back(line_of("all", all));
    for (const auto& [kind, some] : kinds) lines.push_back(line_of(kind, some));
  }
  return markdown_table(lines, 3);
}

}  // namespace weft::evaluate::odometry
