#include "clients/evaluate/floor/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "agents/navigation/config.hpp"
#include "clients/evaluate/floor/scenario.hpp"

namespace weft::evaluate::floor {
namespace {

bool concerns(const Bound& bound, const std::string& kind, const std::string& part) {
  if (repeats_itself(kind) && !bound.of_refusers) return false;
  if (bound.is_share && was_set_by(kind)) return false;
  if (bound.of == Bound::Of::mapping || part == kMapping) return bound.of == Bound::Of::mapping && part == kMapping;
  if (bound.of == Bound::Of::repeat) return true;
  const bool is_easy = is_textured(kind) && part == lights().front();
  return is_easy == (bound.of == Bound::Of::easy);
}

void judge_share(Judged& judged, const std::vector<double>& values, std::size_t seeds) {
  judged.is_judged = seeds >= kSeedsOfAShare;
  judged.median = judged.worst = mean_of(values);
  judged.met = judged.median >= judged.bound->median && judged.median <= judged.bound->worst;
}

}  // namespace

std::map<GroupKey, std::vector<const Score*>> grouped(const Rows& rows, Seeds seeds) {
  std::map<GroupKey, std::vector<const Score*>> groups;
  for (const auto& [key, score] : rows) {
    if (key.seed >= seeds.first && key.seed <= seeds.last) groups[{key.kind, key.part}].push_back(&score);
  }
  return groups;
}

std::vector<double> values_of(const std::vector<const Score*>& scores, double Score::*value) {
  std::vector<double> values;
  for (const Score* const score : scores) values.push_back(score->*value);
  return values;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  double count = 0.0;
  for (const double value : values) {
    if (std::isnan(value)) continue;
    sum += value;
    count += 1.0;
  }
  return count == 0.0 ? Score::kNothing : sum / count;
}

const std::vector<Bound>& bounds() {
  static const double spacing_m = agents::TeachConfig{}.spacing_m;
  using Of = Bound::Of;
  static const std::vector<Bound> all = {
      {"speed error while mapping", "%", "7.1", Of::mapping, &Score::speed_percent, 0.5, 1.0, true},
      {"speed error while mapping, mount wrong by 5 mm and 0.5 degrees", "%", "-", Of::mapping,
       &Score::speed_wrong_mount_percent, 1.5, 2.5, true},
      {"consistency of odometry and localisation speed, textured", "%", "7.2", Of::easy, &Score::consistency_percent,
       1.0, 2.0, false},
      {"consistency of odometry and localisation speed, hardest", "%", "22.5", Of::hard, &Score::consistency_percent,
       3.0, 5.0, false},
      {"blind distance, textured", "m", "0", Of::easy, &Score::blind_m, spacing_m, 2.0 * spacing_m, false},
      {"blind distance, hardest floor and light", "m", "1.4", Of::hard, &Score::blind_m, 0.5, 1.0, false},
      {"repeat path, lateral RMSE", "mm", "drawn only", Of::repeat, &Score::lateral_rmse_mm, 10.0, 20.0, false},
      {"repeat path, lateral worst", "mm", "drawn only", Of::repeat, &Score::lateral_worst_mm, 30.0, 50.0, false},
      {"goal, position", "mm", "-", Of::repeat, &Score::goal_mm, 20.0, 40.0, false},
      {"goal, heading", "deg", "-", Of::repeat, &Score::goal_deg, 1.0, 2.0, false},
      {"heading error in steady state, RMS", "deg", "about 10", Of::repeat, &Score::heading_rms_deg, 1.0, 2.0, false},
      {"speed error at 1.5 m/s, 15 fps and matching blur", "%", "-", Of::mapping, &Score::speed_fast_percent, 1.0,
       3.0, true},
      {"95 % region of 1 m holds the truth, mount calibrated, floors that set nothing", "%", "-", Of::mapping,
       &Score::held_1m_percent, 90.0, 98.0, true, true},
      {"95 % region of 10 m holds the truth, mount calibrated, floors that set nothing", "%", "-", Of::mapping,
       &Score::held_10m_percent, 90.0, 98.0, true, true},
      {"95 % region of 1 m holds the truth, mount as given, floors that set nothing", "%", "-", Of::repeat,
       &Score::held_1m_percent, 90.0, 98.0, false, true},
      {"95 % region of 10 m holds the truth, mount as given, floors that set nothing", "%", "-", Of::repeat,
       &Score::held_10m_percent, 90.0, 98.0, false, true},
      {"wrong fixes in the repeats", "", "-", Of::repeat, &Score::wrong_fixes, 0.0, 0.0, true},
  };
  return all;
}

MedianWorst median_worst(std::vector<double> values) {
  if (values.empty()) return {Score::kNothing, Score::kNothing};
  for (double& value : values) {
    if (std::isnan(value)) value = std::numeric_limits<double>::infinity();
  }
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  const double median = values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
  return {median, values.back()};
}

std::vector<Judged> judge(const Rows& rows, Seeds seeds) {
  const auto groups = grouped(rows, seeds);
  std::vector<Judged> all;
  for (const Bound& bound : bounds()) {
    Judged judged;
    judged.bound = &bound;
    std::vector<double> all_values;
    std::size_t most_seeds = 0;
    for (const auto& [key, scores] : groups) {
      if (!concerns(bound, key.first, key.second)) continue;
      const std::vector<double> values = values_of(scores, bound.value);
      all_values.insert(all_values.end(), values.begin(), values.end());
      most_seeds = std::max(most_seeds, scores.size());
      const MedianWorst of = median_worst(values);
      Group group{key.first, key.second, scores.size(), 0.0, of.median, of.worst, false};
      for (const Score* const score : scores) group.metres += score->metres;
      group.met = of.median <= bound.median && of.worst <= bound.worst;
      judged.median = std::fmax(judged.median, of.median);
      judged.worst = std::fmax(judged.worst, of.worst);
      judged.groups.push_back(std::move(group));
    }
    judged.met = !judged.groups.empty() && std::all_of(judged.groups.begin(), judged.groups.end(),
                                                       [](const Group& group) { return group.met; });
    if (bound.is_share) judge_share(judged, all_values, most_seeds);
    all.push_back(std::move(judged));
  }
  return all;
}

bool is_any_missed(const std::vector<Judged>& all) {
  return std::any_of(all.begin(), all.end(),
                     [](const Judged& judged) { return !judged.groups.empty() && judged.is_judged && !judged.met; });
}

}  // namespace weft::evaluate::floor
