#include "clients/evaluate/floor/relocalise/trial_report.hpp"

#include <algorithm>
#include <utility>

#include "clients/evaluate/floor/bounds.hpp"
#include "clients/evaluate/floor/scenario.hpp"
#include "clients/evaluate/table.hpp"

namespace weft::evaluate::floor {
namespace {

bool found_rightly(const Trial& trial) {
  return trial.found_m && !trial.is_wrong;
}

std::vector<Trial> going(const std::vector<Trial>& trials, Along along) {
  std::vector<Trial> some;
  std::copy_if(trials.begin(), trials.end(), std::back_inserter(some),
               [&](const Trial& trial) { return trial.along == along; });
  return some;
}

std::ptrdiff_t count_wrong(const std::vector<Trial>& trials) {
  return std::count_if(trials.begin(), trials.end(), [](const Trial& trial) { return trial.is_wrong; });
}

double percent_found(const std::vector<Trial>& trials) {
  const auto found = std::count_if(trials.begin(), trials.end(), found_rightly);
  return 100.0 * static_cast<double>(found) / static_cast<double>(trials.size());
}

/// Returns the median metres pushed until the robot was found, of those that were.
double middle_m(const std::vector<Trial>& trials) {
  std::vector<double> metres;
  for (const Trial& trial : trials) {
    if (found_rightly(trial)) metres.push_back(*trial.found_m);
  }
  return median_worst(std::move(metres)).median;
}

}  // namespace

std::vector<TrialGroup> judge(const TrialRows& rows) {
  std::vector<TrialGroup> groups;
  const auto group_of = [&](const RowKey& key, Along along) -> TrialGroup& {
    const auto found = std::find_if(groups.begin(), groups.end(), [&](const TrialGroup& group) {
      return group.kind == key.kind && group.part == key.part && group.along == along;
    });
    return found != groups.end() ? *found : groups.emplace_back(TrialGroup{key.kind, key.part, along, {}, {}, false});
  };
  for (const auto& [key, trials] : rows) {
    for (const Along along : kBothWays) {
      const std::vector<Trial> some = going(trials, along);
      if (some.empty()) continue;
      TrialGroup& group = group_of(key, along);
      group.missed_percent.push_back(100.0 - percent_found(some));
      group.trials.insert(group.trials.end(), some.begin(), some.end());
    }
  }
  for (TrialGroup& group : groups) {
    const MedianWorst missed = median_worst(group.missed_percent);
    const bool is_found = 100.0 - missed.median >= kFoundMedianPercent && 100.0 - missed.worst >= kFoundWorstPercent;
    group.met = count_wrong(group.trials) == 0 && (is_found || repeats_itself(group.kind));
  }
  return groups;
}

std::string tables_of(const TrialRows& rows) {
  std::vector<std::vector<std::string>> cells = {{"floor", "light", "pushed", "", "seeds", "trials",
                                                  "found, %, median", "worst seed", "after, m, median", "WRONG"}};
  for (const TrialGroup& group : judge(rows)) {
    const MedianWorst missed = median_worst(group.missed_percent);
    cells.push_back({group.kind, group.part, name_of(group.along), group.met ? "met" : "NOT MET",
                     std::to_string(group.missed_percent.size()), std::to_string(group.trials.size()),
                     cell(100.0 - missed.median, 2), cell(100.0 - missed.worst, 2), cell(middle_m(group.trials), 2),
                     std::to_string(count_wrong(group.trials))});
  }
  return markdown_table(cells, 4);
}

}  // namespace weft::evaluate::floor
