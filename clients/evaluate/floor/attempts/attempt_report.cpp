#include "clients/evaluate/floor/attempts/attempt_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "clients/chart/chart.hpp"
#include "clients/evaluate/table.hpp"

namespace weft::evaluate::floor {
namespace {

using namespace charts;

using Cells = std::vector<std::vector<std::string>>;
constexpr double kDegreesARad = 180.0 / std::numbers::pi;
constexpr std::array kInks = {kBlue, kVermilion, kGreen, kOrange, kPurple, kSky, kInk, kQuiet};

std::map<std::string, Tally> by_kind(const AttemptRows& rows) {
  std::map<std::string, Tally> kinds;
  for (const auto& [key, tally] : rows) kinds[key.kind].add(tally);
  return kinds;
}

const Outcomes& outcomes_of(const Tally& tally, const char* sort) {
  static const Outcomes none;
  const auto found = tally.sorts.find(sort);
  return found == tally.sorts.end() ? none : found->second;
}

std::string share(std::size_t part, std::size_t whole) {
  return whole == 0 ? "-" : cell(100.0 * static_cast<double>(part) / static_cast<double>(whole), 1);
}
std::string recall_of(const Tally& tally, const char* sort) {
  const Outcomes& of = outcomes_of(tally, sort);
  return share(of.right, of.attempts());
}

std::vector<std::string> row_of(const std::string& kind, const std::string& light, const Tally& tally) {
  return {kind,
          light,
          std::to_string(tally.attempts()),
          recall_of(tally, attempted::kNear),
          recall_of(tally, attempted::kNearGuided),
          recall_of(tally, attempted::kTracking),
          recall_of(tally, attempted::kStitching),
          std::to_string(tally.wrong())};
}

std::string table_by_floor(const AttemptRows& rows) {
  std::map<std::pair<std::string, std::string>, Tally> groups;
  Tally all;
  for (const auto& [key, tally] : rows) {
    groups[{key.kind, key.part}].add(tally);
    all.add(tally);
  }
  Cells cells = {
      {"floor", "light", "attempts", "near, %", "near, guided, %", "tracking, %", "stitching, %", "WRONG"}};
  for (const auto& [key, tally] : groups) cells.push_back(row_of(key.first, key.second, tally));
  cells.push_back(row_of("all", "", all));
  return markdown_table(cells, 2);
}

std::string table_by_sort(const AttemptRows& rows) {
  Tally all;
  for (const auto& [key, tally] : rows) all.add(tally);
  Cells cells = {{"attempt", "refused most often for", "attempts", "right", "refused", "WRONG"}};
  for (const auto& [sort, outcomes] : all.sorts) {
    std::vector<std::pair<std::size_t, std::string>> reasons;
    for (const auto& [reason, count] : outcomes.refused) reasons.emplace_back(count, reason);
    std::sort(reasons.rbegin(), reasons.rend());
    std::string words;
    for (std::size_t i = 0; i < std::min<std::size_t>(3, reasons.size()); ++i)
      words += (i == 0 ? "" : ", ") + reasons[i].second + " " + std::to_string(reasons[i].first);
    cells.push_back({sort, words, std::to_string(outcomes.attempts()), std::to_string(outcomes.right),
                     std::to_string(outcomes.all_refused()), std::to_string(outcomes.wrong)});
  }
  return markdown_table(cells, 2);
}

std::string pose_words(const Pose2& pose) {
  return cell(pose.x, 2) + " " + cell(pose.y, 2) + " " + cell(kDegreesARad * pose.heading, 1);
}

std::string table_of_wrong(const AttemptRows& rows) {
  Cells cells = {
      {"WRONG: floor", "light", "attempt", "robot at (m, m, degrees)", "place at", "seed", "off, m", "off, degrees"}};
  for (const auto& [key, tally] : rows) {
    for (const WrongOne& one : tally.wrong_ones) {
      cells.push_back({key.kind, key.part, one.sort, pose_words(one.site_from_robot), pose_words(one.site_from_place),
                       std::to_string(key.seed), cell(one.off_m, 3), cell(kDegreesARad * one.off_rad, 2)});
    }
  }
  return cells.size() == 1 ? "" : "\n" + markdown_table(cells, 5);
}

using Bins = std::array<std::size_t, Recall::kBins>;

/// Bins with too few attempts say nothing.
Curve recall_curve(const std::string& name, const Bins& tried, const Bins& right, double bin, const Colour& ink) {
  constexpr std::size_t kFewestInBin = 5;
  Curve curve{name, {}, ink, Curve::Look::line, 1.8};
  for (std::size_t i = 0; i < Recall::kBins; ++i) {
    if (tried[i] < kFewestInBin) continue;
    curve.dots.push_back(
        {bin * (static_cast<double>(i) + 0.5), static_cast<double>(right[i]) / static_cast<double>(tried[i])});
  }
  return curve;
}

Chart recall_chart(const std::map<std::string, Tally>& kinds, const char* sort, bool by_heading) {
  Chart chart{std::string(sort) + (by_heading ? ", by heading" : ", by distance"),
              by_heading ? "headings differ by, degrees" : "middles of what both see apart, m",
              "share found",
              {},
              false,
              Dot{0.0, 1.02},
              false};
  std::size_t i = 0;
  for (const auto& [kind, tally] : kinds) {
    const auto found = tally.recalls.find(sort);
    const Recall recall = found == tally.recalls.end() ? Recall{} : found->second;
    const Colour& ink = kInks.at(i++ % kInks.size());
    chart.curves.push_back(
        by_heading ? recall_curve(kind, recall.tried_by_heading, recall.right_by_heading,
                                  kDegreesARad * Recall::kBinRad, ink)
                   : recall_curve(kind, recall.tried_by_metres, recall.right_by_metres, Recall::kBinM, ink));
  }
  return chart;
}

/// A dot a floor and reason; the floors stand side by side, each reason's share of all attempts on it.
Chart refusal_chart(const std::map<std::string, Tally>& kinds, const std::vector<const char*>& sorts,
                    const std::string& title) {
  std::map<std::string, std::vector<Dot>> by_reason;
  std::string names;
  double at = 0.0;
  for (const auto& [kind, tally] : kinds) {
    at += 1.0;
    names += (names.empty() ? "" : ", ") + cell(at, 0) + " " + kind;
    std::size_t all = 0;
    std::map<std::string, std::size_t> refused;
    for (const char* const sort : sorts) {
      const Outcomes& outcomes = outcomes_of(tally, sort);
      all += outcomes.attempts();
      for (const auto& [reason, count] : outcomes.refused) refused[reason] += count;
    }
    for (const auto& [reason, count] : refused)
      by_reason[reason].push_back({at, static_cast<double>(count) / static_cast<double>(all)});
  }
  std::vector<std::pair<double, std::string>> order;
  for (const auto& [reason, dots] : by_reason) {
    double sum = 0.0;
    for (const Dot& dot : dots) sum += dot.y;
    order.emplace_back(sum, reason);
  }
  std::sort(order.rbegin(), order.rend());
  constexpr std::size_t kNamed = 3;  // as many as a legend has room for
  Chart chart{title, names, "share of the attempts", {}, false, Dot{-0.02, 1.02}, false};
  // From half a floor before the first to half a floor behind the last.
  chart.curves.push_back({"", {{0.5, 0.0}, {at + 0.5, 0.0}}, kQuiet, Curve::Look::line, 0.5});
  Curve others{"others", std::vector<Dot>(kinds.size()), kQuiet, Curve::Look::dots, 3.0};
  for (std::size_t i = 0; i < kinds.size(); ++i) others.dots[i].x = static_cast<double>(i + 1);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::vector<Dot>& dots = by_reason[order[i].second];
    if (i < kNamed) {
      chart.curves.push_back({order[i].second, dots, kInks.at(i), Curve::Look::dots, 4.5});
      continue;
    }
    for (const Dot& dot : dots) others.dots[static_cast<std::size_t>(dot.x) - 1].y += dot.y;
  }
  chart.curves.push_back(std::move(others));
  return chart;
}

}  // namespace

std::string tables_of(const AttemptRows& rows) {
  return table_by_floor(rows) + "\n" + table_by_sort(rows) + table_of_wrong(rows);
}

Result<void> draw_attempts(const AttemptRows& rows, const std::string& about, const std::filesystem::path& folder) {
  const std::map<std::string, Tally> kinds = by_kind(rows);
  using namespace attempted;
  return draw_charts("Attempts to relate views with places", about,
                     {recall_chart(kinds, kNear, false), recall_chart(kinds, kNear, true),
                      recall_chart(kinds, kNearGuided, false), recall_chart(kinds, kNearGuided, true),
                      refusal_chart(kinds, {kNear, kNearGuided}, "refused though there is a right answer"),
                      refusal_chart(kinds, {kElsewhere, kLookAlike, kElsewhereGuided, kMirrored, kOtherFloor},
                                    "refused where there is none")},
                     2, folder / "floor-attempts.png");
}

}  // namespace weft::evaluate::floor
