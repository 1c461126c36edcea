#include "clients/evaluate/bearing/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "clients/evaluate/bearing/trials.hpp"
#include "clients/evaluate/table.hpp"

namespace weft::evaluate::bearing {
namespace {

double worst_of(const std::vector<double>& values) {
  double worst = values.empty() ? Score::kNothing : 0.0;
  for (const double value : values) worst = std::isnan(value) ? value : std::max(worst, value);
  return worst;
}

template <class Get>
std::vector<double> of_seeds(const Rows& rows, Seeds seeds, const std::string& trial, Get get) {
  std::vector<double> values;
  for (const auto& [key, score] : rows) {
    if (key.first == trial && key.second >= seeds.first && key.second <= seeds.last) values.push_back(get(score));
  }
  return values;
}

std::string how_it_ended(const Rows& rows, Seeds seeds, const Trial& trial) {
  std::size_t all = 0;
  std::size_t whole = 0;
  std::string why;
  for (const auto& [key, score] : rows) {
    if (key.first != trial.name || key.second < seeds.first || key.second > seeds.last) continue;
    ++all;
    if (score.ended.empty()) ++whole;
    if (!score.ended.empty()) why = ", " + score.ended;
  }
  return std::to_string(whole) + " of " + std::to_string(all) + why;
}

}  // namespace

double median_of(std::vector<double> values) {
  if (values.empty()) return Score::kNothing;
  std::sort(values.begin(), values.end(), [](double a, double b) { return std::isnan(b) ? !std::isnan(a) : a < b; });
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

const std::vector<Bound>& bounds() {
  using Of = Bound::Of;
  static const std::vector<Bound> all = {
      {"oval", Of::error_m, 2, "0.07", 0.05, 0.10},
      {"oval", Of::error_m, 20, "0.07", 0.03, 0.05},
      {"lemniscate", Of::error_m, 19, "< 0.10", 0.05, 0.08},
      {"yard-day", Of::error_m, 7, "0.2 to 0.3", 0.10, 0.20},
      {"yard-dark", Of::error_m, 7, "0.2 to 0.3", 0.15, 0.30},
      {"yard-half", Of::error_m, 7, "0.2 to 0.3", 0.15, 0.30},
      {"oval-bad-wheels", Of::error_m, 2, "-", 0.075, 0.15},
      {"oval-bad-wheels", Of::error_m, 20, "-", 0.045, 0.075},
      {"lemniscate-bad-wheels", Of::error_m, 19, "-", 0.075, 0.12},
      {"yard-bad-wheels", Of::error_m, 7, "-", 0.15, 0.30},
      {"yard-dark-bad-wheels", Of::error_m, 7, "-", 0.225, 0.45},
      {"yard-half-bad-wheels", Of::error_m, 7, "-", 0.225, 0.45},
      {"yard-changed", Of::error_m, 7, "-", 0.15, 0.30},
      {"oval-as-published", Of::band_m, 1, "by eye", 0.15, 0.15},
      {"oval-profile-only", Of::drift_m_a_loop, 1, "about 1", 0.3, 0.1},
      {"corners-vision-only", Of::loops_driven, 1, "0", 0.0, 0.0},
  };
  return all;
}

std::string name_of(const Bound& bound) {
  const std::string trial = std::string(bound.trial) + ", ";
  switch (bound.of) {
    case Bound::Of::band_m:
      return trial + "first loop beside the model";
    case Bound::Of::drift_m_a_loop:
      return trial + "goes astray by at least, a loop";
    case Bound::Of::loops_driven:
      return trial + "loops before it is lost";
    case Bound::Of::error_m:
      break;
  }
  return trial + "after " + std::to_string(bound.loops) + " loops";
}

double value_of(const Bound& bound, const Score& score) {
  const std::vector<double>& after = score.after_loop_m;
  switch (bound.of) {
    case Bound::Of::band_m:
      return score.band_m;
    case Bound::Of::drift_m_a_loop:  // off the way before the first loop was over
      return after.empty() ? std::numeric_limits<double>::infinity()
                           : after.back() / static_cast<double>(after.size());
    case Bound::Of::loops_driven:
      return static_cast<double>(after.size());
    case Bound::Of::error_m:
      break;
  }
  return score.after(bound.loops);
}

std::vector<double> errors_after(const Rows& rows, Seeds seeds, const std::string& trial, std::size_t loops) {
  return of_seeds(rows, seeds, trial, [&](const Score& score) { return score.after(loops); });
}

std::vector<Judged> judge(const Rows& rows, Seeds seeds) {
  std::vector<Judged> all;
  for (const Bound& bound : bounds()) {
    const auto values = of_seeds(rows, seeds, bound.trial, [&](const Score& s) { return value_of(bound, s); });
    Judged judged{&bound, values.size(), median_of(values), worst_of(values), false};
    judged.met = judged.median <= bound.median && judged.worst <= bound.worst;  // false for NaN
    if (bound.is_least() && !values.empty()) {
      judged.worst = *std::min_element(values.begin(), values.end());
      judged.met = judged.median >= bound.median && judged.worst >= bound.worst;
    }
    all.push_back(judged);
  }
  return all;
}

bool is_any_missed(const std::vector<Judged>& all) {
  return std::any_of(all.begin(), all.end(), [](const Judged& judged) { return judged.seeds > 0 && !judged.met; });
}

std::string tables_of(const Rows& rows, Seeds seeds) {
  std::vector<std::vector<std::string>> promised = {
      {"error, m", "", "paper", "seeds", "median", "bound", "worst", "bound"}};
  for (const Judged& judged : judge(rows, seeds)) {
    const char* const verdict = judged.seeds == 0 ? "not measured" : judged.met ? "met" : "NOT MET";
    promised.push_back({name_of(*judged.bound), verdict, judged.bound->paper, std::to_string(judged.seeds),
                        cell(judged.median, 3), cell(judged.bound->median, 3), cell(judged.worst, 3),
                        cell(judged.bound->worst, 3)});
  }
  std::vector<std::vector<std::string>> runs = {
      {"trial", "what", "whole", "loops", "metres", "l, m", "first loop, m", "second", "last", "model's band, m"}};
  for (const Trial& trial : trials()) {
    const auto metres = of_seeds(rows, seeds, trial.name, [](const Score& score) { return score.metres; });
    if (metres.empty()) continue;
    double all_metres = 0.0;
    for (const double some : metres) all_metres += some;
    const auto after = [&](std::size_t loops) {
      return cell(median_of(errors_after(rows, seeds, trial.name, loops)), 3);
    };
    runs.push_back(
        {trial.name, trial.about, how_it_ended(rows, seeds, trial), std::to_string(trial.loops), cell(all_metres, 0),
         cell(median_of(of_seeds(rows, seeds, trial.name, [](const Score& s) { return s.landmark_m; })), 1), after(1),
         trial.loops > 1 ? after(2) : "-", after(trial.loops),
         cell(worst_of(of_seeds(rows, seeds, trial.name, [](const Score& s) { return s.band_m; })), 2)});
  }
  return markdown_table(promised, 3) + "\n" + markdown_table(runs, 3);
}

}  // namespace weft::evaluate::bearing
