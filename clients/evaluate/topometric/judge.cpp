#include <algorithm>
#include <cmath>

#include "clients/evaluate/floor/bounds.hpp"
#include "clients/evaluate/table.hpp"
#include "clients/evaluate/topometric/bounds.hpp"
#include "clients/evaluate/topometric/spread.hpp"
#include "clients/evaluate/topometric/trials.hpp"

namespace weft::evaluate::topometric {
namespace {

using Sense = Bound::Sense;

std::vector<double> values_of_bound(const Rows& rows, Seeds asked, const Bound& bound) {
  std::vector<double> values;
  const Seeds seeds = seeds_of(bound.trial, asked);
  for (const auto& [key, score] : rows)
    if (key.first == bound.trial && key.second >= seeds.first && key.second <= seeds.last &&
        score.values.contains(bound.value))
      values.push_back(score.value(bound.value));
  return values;
}

/// Judges median and worst; of what is to be at least so much, mirrored. What is no number is the worst.
void judge_by_spread(std::vector<double> values, bool by_worst, Judged& judged) {
  const Bound& bound = *judged.bound;
  const double sign = bound.sense == Sense::at_least ? -1.0 : 1.0;
  for (double& value : values) value *= sign;
  const floor::MedianWorst spread = floor::median_worst(values);
  judged.median = sign * spread.median;
  judged.worst = sign * spread.worst;
  const double asked = by_worst && !std::isnan(bound.worst) ? bound.worst : bound.median;
  const bool median_holds = spread.median <= sign * asked;
  const bool worst_holds = std::isnan(bound.worst) || spread.worst <= sign * bound.worst;
  judged.verdict = median_holds && worst_holds ? Verdict::met : Verdict::missed;
}

void judge_each_between(const std::vector<double>& values, Judged& judged) {
  const Bound& bound = *judged.bound;
  const double middle = (bound.median + bound.worst) / 2;
  judged.median = floor::median_worst(values).median;
  judged.worst = *std::max_element(values.begin(), values.end(),
                                   [&](double a, double b) { return std::abs(a - middle) < std::abs(b - middle); });
  const bool holds = std::all_of(values.begin(), values.end(),
                                 [&](double value) { return value >= bound.median && value <= bound.worst; });
  judged.verdict = holds ? Verdict::met : Verdict::missed;
}

void judge_mean(const std::vector<double>& values, Judged& judged) {
  judged.median = judged.worst = mean_of(values);
  judged.verdict = judged.median >= judged.bound->median ? Verdict::met : Verdict::missed;
}

std::string asked_of_bound(const Bound& bound) {
  const auto number = [&](double value) { return cell(value, bound.digits); };
  if (bound.sense == Sense::between) return number(bound.median) + " .. " + number(bound.worst);
  if (bound.sense == Sense::mean_at_least) return "mean >= " + number(bound.median);
  const std::string worst = std::isnan(bound.worst) ? "" : " (" + number(bound.worst) + ")";
  return (bound.sense == Sense::at_most ? "<= " : ">= ") + number(bound.median) + worst;
}

}  // namespace

const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::met:
      return "met";
    case Verdict::missed:
      return "NOT MET";
    case Verdict::not_measured:
      break;
  }
  return "not measured";
}

std::vector<Judged> judge(const Rows& rows, Seeds seeds, bool by_worst) {
  std::vector<Judged> all;
  for (const Bound& bound : bounds()) {
    const std::vector<double> values = values_of_bound(rows, seeds, bound);
    Judged& judged = all.emplace_back();
    judged.bound = &bound;
    judged.seeds = values.size();
    if (values.empty()) continue;
    if (bound.sense == Sense::between) {
      judge_each_between(values, judged);
    } else if (bound.sense == Sense::mean_at_least) {
      judge_mean(values, judged);
    } else {
      judge_by_spread(values, by_worst, judged);
    }
  }
  return all;
}

bool is_any_missed(const std::vector<Judged>& all) {
  return std::any_of(all.begin(), all.end(), [](const Judged& one) { return one.verdict == Verdict::missed; });
}

std::string table_of(const std::vector<Judged>& all) {
  std::vector<std::vector<std::string>> rows = {
      {"row", "measure", "asked: median (worst)", "verdict", "paper", "median", "worst", "seeds"}};
  for (const Judged& judged : all) {
    const Bound& bound = *judged.bound;
    const std::string unit = *bound.unit == '\0' ? "" : std::string(", ") + bound.unit;
    rows.push_back({bound.row, bound.measure + unit, asked_of_bound(bound), to_string(judged.verdict), bound.paper,
                    cell(judged.median, bound.digits), cell(judged.worst, bound.digits),
                    std::to_string(judged.seeds)});
  }
  return markdown_table(rows, 5);
}

}  // namespace weft::evaluate::topometric
