#include "clients/evaluate/bearing/relocalise/led_report.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "clients/evaluate/bearing/bounds.hpp"
#include "clients/evaluate/table.hpp"

namespace weft::evaluate::bearing {
namespace {

std::vector<Led> trials_of(const LedRows& rows, const std::string& kind, const std::string& light) {
  std::vector<Led> all;
  for (const auto& [key, trials] : rows.trials)
    if (key.kind == kind && key.light == light) all.insert(all.end(), trials.begin(), trials.end());
  return all;
}

LedGroup group_of(const LedRows& rows, const LookAlikes& kind, const std::string& light) {
  LedGroup group{&kind, light};
  std::vector<double> metres;
  for (const auto& [key, trials] : rows.trials) group.seeds += key.kind == kind.name && key.light == light ? 1 : 0;
  for (const Led& led : trials_of(rows, kind.name, light)) {
    if (!led.found_m) {
      ++group.refused;
    } else if (is_right(led)) {
      ++group.right;
      metres.push_back(*led.found_m);
    } else {
      ++group.wrong;
    }
  }
  group.after_m = median_of(metres);
  group.met = !kind.is_judged || (group.wrong == 0 && static_cast<double>(group.right) >=
                                                          kind.found_share * static_cast<double>(group.trials()));
  return group;
}

std::string percent(std::size_t some, std::size_t all) {
  return cell(100.0 * static_cast<double>(some) / static_cast<double>(std::max<std::size_t>(1, all)), 0);
}

}  // namespace

std::vector<LedGroup> judge(const LedRows& rows) {
  std::vector<LedGroup> groups;
  for (const LookAlikes& kind : look_alikes()) {
    for (const OtherLight& light : other_lights()) {
      LedGroup group = group_of(rows, kind, light.name);
      if (group.trials() > 0) groups.push_back(std::move(group));
    }
  }
  return groups;
}

std::string tables_of(const LedRows& rows) {
  std::vector<std::vector<std::string>> cells = {
      {"aisles", "light", "", "seeds", "trials", "found, %", "asked, %", "after, m, median", "refused", "WRONG"}};
  LedGroup all;
  for (const LedGroup& group : judge(rows)) {
    const bool is_judged = group.kind->is_judged;
    if (is_judged) all.right += group.right;
    if (is_judged) all.wrong += group.wrong;
    if (is_judged) all.refused += group.refused;
    const double asked = 100.0 * group.kind->found_share;
    cells.push_back({group.kind->about, group.light, is_judged ? (group.met ? "met" : "NOT MET") : "not judged",
                     std::to_string(group.seeds), std::to_string(group.trials()),
                     percent(group.right, group.trials()), asked > 0.0 ? cell(asked, 0) : "-", cell(group.after_m, 2),
                     std::to_string(group.refused), std::to_string(group.wrong)});
  }
  cells.push_back({"all that is judged", "", "", "", std::to_string(all.trials()), percent(all.right, all.trials()),
                   "-", "-", std::to_string(all.refused), std::to_string(all.wrong)});
  std::map<std::string, Pairs> by_loads;
  for (const auto& [key, pairs] : rows.pairs) by_loads[key.first].add(pairs);
  std::vector<std::vector<std::string>> of_pairs = {
      {"pairs of different places", "tried", "the vote alone tells a heading", "related without a guess"}};
  for (const auto& [loads, pairs] : by_loads)
    of_pairs.push_back(
        {loads, std::to_string(pairs.tried), std::to_string(pairs.voted), std::to_string(pairs.related)});
  return markdown_table(cells, 3) + "\n" + markdown_table(of_pairs, 1);
}

}  // namespace weft::evaluate::bearing
