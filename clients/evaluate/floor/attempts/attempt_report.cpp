#include "clients/evaluate/floor/attempts/attempt_report.hpp"

#include <algorithm>
#include <numbers>
#include <utility>
#include <vector>

#include "clients/evaluate/table.hpp"

namespace weft::evaluate::floor {
namespace {

using Cells = std::vector<std::vector<std::string>>;
constexpr double kInDegrees = 180.0 / std::numbers::pi;

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
  return cell(pose.x, 2) + " " + cell(pose.y, 2) + " " + cell(kInDegrees * pose.heading, 1);
}

std::string table_of_wrong(const AttemptRows& rows) {
  Cells cells = {
      {"WRONG: floor", "light", "attempt", "robot at (m, m, degrees)", "place at", "seed", "off, m", "off, degrees"}};
  for (const auto& [key, tally] : rows) {
    for (const WrongOne& one : tally.wrong_ones) {
      cells.push_back({key.kind, key.part, one.sort, pose_words(one.site_from_robot), pose_words(one.site_from_place),
                       std::to_string(key.seed), cell(one.off_m, 3), cell(kInDegrees * one.off_rad, 2)});
    }
  }
  return cells.size() == 1 ? "" : "\n" + markdown_table(cells, 5);
}

}  // namespace

std::string tables_of(const AttemptRows& rows) {
  return table_by_floor(rows) + "\n" + table_by_sort(rows) + table_of_wrong(rows);
}

}  // namespace weft::evaluate::floor
