#include "clients/evaluate/floor/relocalise/trial_report.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "clients/chart/chart.hpp"
#include "clients/evaluate/floor/bounds.hpp"
#include "clients/evaluate/floor/scenario.hpp"
#include "clients/evaluate/table.hpp"

namespace weft::evaluate::floor {
namespace {

using namespace charts;

constexpr std::array kTrialInks = {kBlue, kVermilion, kGreen, kOrange, kPurple, kSky, kInk, kQuiet};

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

/// Pushed until it was found; of all that were found.
double middle_m(const std::vector<Trial>& trials) {
  std::vector<double> metres;
  for (const Trial& trial : trials) {
    if (found_rightly(trial)) metres.push_back(*trial.found_m);
  }
  return median_worst(std::move(metres)).median;
}

/// A curve a floor: x metres pushed, y the share found.
Chart found_chart(const std::map<std::string, std::vector<Trial>>& kinds, Along along) {
  Chart chart{std::string("pushed ") + name_of(along) + " along the way",
              "pushed, m",
              "share found",
              {},
              false,
              Dot{0.0, 1.02},
              false};
  std::size_t i = 0;
  for (const auto& [kind, all] : kinds) {
    const std::vector<Trial> trials = going(all, along);
    std::vector<double> metres;
    for (const Trial& trial : trials) {
      if (found_rightly(trial)) metres.push_back(*trial.found_m);
    }
    std::sort(metres.begin(), metres.end());
    Curve curve{kind, {{0.0, 0.0}}, kTrialInks.at(i++ % kTrialInks.size()), Curve::Look::steps, 1.8};
    for (std::size_t k = 0; k < metres.size(); ++k)
      curve.dots.push_back({metres[k], static_cast<double>(k + 1) / static_cast<double>(trials.size())});
    curve.dots.push_back({kPushM, static_cast<double>(metres.size()) / static_cast<double>(trials.size())});
    chart.curves.push_back(std::move(curve));
  }
  return chart;
}

Chart failure_map(const std::string& kind, const std::vector<Trial>& trials,
                  const std::vector<agents::SitePoint>& line) {
  Curve way{"taught", {}, kQuiet, Curve::Look::line, 1.0};
  for (const agents::SitePoint& point : line) way.dots.push_back({point.x, point.y});
  Curve lost{"not found", {}, kOrange, Curve::Look::dots, 3.5};
  Curve wrong{"WRONG", {}, kInk, Curve::Look::dots, 5.0};
  for (const Trial& trial : trials) {
    const Dot at{trial.site_from_robot.x, trial.site_from_robot.y};
    if (trial.is_wrong) {
      wrong.dots.push_back(at);
    } else if (!trial.found_m) {
      lost.dots.push_back(at);
    }
  }
  const std::string title = kind + ": " + std::to_string(lost.dots.size()) + " of " + std::to_string(trials.size()) +
                            " not found, " + std::to_string(wrong.dots.size()) + " wrong";
  return {title, "x, m", "y, m", {way, lost, wrong}, true, {}, false};
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

Result<void> draw_trials(const TrialRows& rows, const std::vector<agents::SitePoint>& line, const std::string& about,
                         const std::filesystem::path& folder) {
  std::map<std::string, std::vector<Trial>> kinds;
  for (const auto& [key, trials] : rows) kinds[key.kind].insert(kinds[key.kind].end(), trials.begin(), trials.end());
  std::vector<Chart> charts;
  for (const Along along : kBothWays) charts.push_back(found_chart(kinds, along));
  for (const auto& [kind, trials] : kinds) charts.push_back(failure_map(kind, trials, line));
  return draw_charts("Robots that know nothing, pushed until they know where they are", about, charts, 2,
                     folder / "floor-relocalise.png");
}

}  // namespace weft::evaluate::floor
