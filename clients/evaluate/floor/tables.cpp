#include "clients/evaluate/floor/tables.hpp"

#include <algorithm>
#include <cstdint>

#include "clients/evaluate/floor/scenario.hpp"
#include "clients/evaluate/table.hpp"

namespace weft::evaluate::floor {
namespace {

using Cells = std::vector<std::vector<std::string>>;
using Groups = std::map<GroupKey, std::vector<const Score*>>;

std::string verdict_of(const Judged& judged) {
  if (judged.groups.empty()) return std::string("not measured (weft-evaluate ") + judged.command + ")";
  if (!judged.is_judged) return "not judged (of " + std::to_string(kSeedsOfAShare) + " seeds or more)";
  return judged.met ? "met" : "NOT MET";
}

std::string promises_table(const std::vector<Judged>& promises) {
  Cells cells = {
      {"of every floor and light the worst", "unit", "", "paper", "median", "bound", "worst seed", "bound"}};
  for (const Judged& judged : promises) {
    const Bound& bound = *judged.bound;
    const std::string of = judged.of ? ", of " + std::to_string(*judged.of) : std::string();
    cells.push_back({bound.name + of, bound.unit, verdict_of(judged), bound.paper, cell(judged.median, 2),
                     cell(bound.median, 1), cell(judged.worst, 2), cell(bound.worst, 1)});
  }
  return markdown_table(cells, 3);
}

std::string medians_table(const Groups& groups) {
  Cells cells = {{"floor", "part"}};
  for (const Column& column : columns()) cells.front().emplace_back(column.heading);
  for (const auto& [key, scores] : groups) {
    for (const bool is_worst : {false, true}) {
      cells.push_back({key.first, key.second + (is_worst ? ", worst" : ", median")});
      for (const Column& column : columns()) {
        const MedianWorst of = median_worst(values_of(scores, column.value));
        cells.back().push_back(cell(is_worst ? of.worst : of.median, column.digits));
      }
    }
  }
  return markdown_table(cells, 2);
}

/// Returns the table of means: a bound on how often a region holds is one on all robots together.
std::string shares_table(const Groups& groups) {
  std::map<std::string, std::vector<const Score*>> mapping;
  std::map<std::string, std::vector<const Score*>> repeats;
  for (const auto& [key, scores] : groups) {
    std::vector<const Score*>& into = (key.second == kMapping ? mapping : repeats)[key.first];
    into.insert(into.end(), scores.begin(), scores.end());
  }
  Cells cells = {{"95 % regions hold, %", "", "calibrated, 1 m", "10 m", "as given, 1 m", "10 m"}};
  for (const auto& [kind, scores] : mapping) {
    cells.push_back({kind, was_set_by(kind) ? "set by it" : "held out"});
    const std::vector<const Score*>& repeated = repeats[kind];
    for (const std::vector<const Score*>* const part : {&scores, &repeated}) {
      for (double Score::*const value : {&Score::held_1m_percent, &Score::held_10m_percent})
        cells.back().push_back(cell(mean_of(values_of(*part, value)), 1));
    }
  }
  return markdown_table(cells, 2);
}

/// Returns how often views were refused over all seeds, the most frequent reason first.
std::string refusals_table(const Groups& groups) {
  Cells cells = {{"floor", "part", "refused", "times"}};
  for (const auto& [key, scores] : groups) {
    std::map<std::string, std::uint64_t> times;
    for (const Score* const score : scores)
      for (const auto& [reason, some] : score->refusals) times[reason] += some;
    std::vector<std::pair<std::string, std::uint64_t>> ordered(times.begin(), times.end());
    std::stable_sort(ordered.begin(), ordered.end(),
                     [](const auto& a, const auto& b) { return a.second > b.second; });
    for (const auto& [reason, some] : ordered) cells.push_back({key.first, key.second, reason, std::to_string(some)});
  }
  return markdown_table(cells, 3);
}

}  // namespace

std::string tables_of(const std::vector<Judged>& promises, const Rows& rows, Seeds seeds) {
  const Groups groups = grouped(rows, seeds);
  return promises_table(promises) + "\n" + medians_table(groups) + "\n" + shares_table(groups) + "\n" +
         refusals_table(groups);
}

}  // namespace weft::evaluate::floor
