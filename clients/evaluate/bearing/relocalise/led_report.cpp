#include "clients/evaluate/bearing/relocalise/led_report.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "clients/chart/chart.hpp"
#include "clients/evaluate/bearing/bounds.hpp"
#include "clients/evaluate/table.hpp"

namespace weft::evaluate::bearing {
namespace {

using namespace charts;

constexpr std::array kLedInks = {kBlue, kVermilion, kGreen, kOrange, kPurple, kSky, kInk, kQuiet};

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

/// x: metres led, y: the share that has found itself.
Chart found_chart(const LedRows& rows, const std::string& light) {
  Chart chart{"light: " + light, "led, m", "share found rightly", {}, false, Dot{0.0, 1.02}, false};
  std::size_t ink = 0;
  for (const LookAlikes& kind : look_alikes()) {
    const std::vector<Led> trials = trials_of(rows, kind.name, light);
    if (trials.empty() || kind.where == LookAlikes::Where::not_taught) continue;  // there no answer is right
    std::vector<double> metres;
    for (const Led& led : trials)
      if (led.found_m && is_right(led)) metres.push_back(*led.found_m);
    std::sort(metres.begin(), metres.end());
    Curve curve{kind.name, {{0.0, 0.0}}, kLedInks.at(ink++ % kLedInks.size()), Curve::Look::steps, 1.8};
    const auto share = [&](std::size_t some) {
      return static_cast<double>(some) / static_cast<double>(trials.size());
    };
    for (std::size_t i = 0; i < metres.size(); ++i) curve.dots.push_back({metres[i], share(i + 1)});
    const double end_m = metres.empty() ? kLedM : std::max(kLedM, metres.back());
    curve.dots.push_back({end_m, share(metres.size())});
    chart.curves.push_back(std::move(curve));
  }
  return chart;
}

Chart map_of(const LedRows& rows, const LookAlikes& kind) {
  Curve right{"found", {}, kGreen, Curve::Look::dots, 2.5};
  Curve refused{"not found", {}, kQuiet, Curve::Look::dots, 2.5};
  Curve wrong{"WRONG", {}, kVermilion, Curve::Look::dots, 5.0};
  for (const auto& [key, trials] : rows.trials) {
    if (key.kind != kind.name) continue;
    for (const Led& led : trials)
      (!led.found_m    ? refused
       : is_right(led) ? right
                       : wrong)
          .dots.push_back({led.site_from_robot.x, led.site_from_robot.y});
  }
  const std::string title = kind.name + ": " + std::to_string(right.dots.size()) + " found, " +
                            std::to_string(refused.dots.size()) + " not, " + std::to_string(wrong.dots.size()) +
                            " wrong";
  return {title, "x, m", "y, m", {refused, right, wrong}, true, {}, false};
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

Result<void> draw_led(const LedRows& rows, const std::string& about, const std::filesystem::path& folder) {
  std::set<std::string> kinds;
  for (const auto& [key, trials] : rows.trials) kinds.insert(key.kind);
  std::vector<Chart> drawn;
  for (const OtherLight& light : other_lights()) drawn.push_back(found_chart(rows, light.name));
  for (const LookAlikes& kind : look_alikes())
    if (kinds.contains(kind.name)) drawn.push_back(map_of(rows, kind));
  return draw_charts("Robots that know nothing, put down among aisles that look alike", about, drawn, 2,
                     folder / "bearing-relocalise.png");
}

}  // namespace weft::evaluate::bearing
