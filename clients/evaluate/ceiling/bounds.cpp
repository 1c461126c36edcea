#include "clients/evaluate/ceiling/bounds.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "clients/evaluate/floor/bounds.hpp"
#include "clients/evaluate/table.hpp"

namespace weft::evaluate::ceiling {
namespace {

using Sense = Bound::Sense;

/// Returns the seeds' values of a bound's trial, or of all trials that have it, in order.
std::vector<double> values_in(const Rows& rows, Seeds seeds, const std::string& of_trial, const std::string& name) {
  std::vector<double> values;
  for (const auto& [key, score] : rows) {
    const auto& [trial, seed] = key;
    if (!of_trial.empty() && trial != of_trial) continue;
    const Seeds driven = seeds_of(trial, seeds);
    if (seed < driven.first || seed > driven.last || !score.values.contains(name)) continue;
    values.push_back(score.value(name));
  }
  return values;
}

double sum_of(const Rows& rows, Seeds seeds, const Bound& bound, const std::vector<std::string>& names,
              std::size_t& count) {
  double sum = 0.0;
  for (const std::string& name : names) {
    const std::vector<double> values = values_in(rows, seeds, bound.trial, name);
    sum += std::accumulate(values.begin(), values.end(), 0.0);
    count = std::max(count, values.size());
  }
  return sum;
}

void judge_none(const Rows& rows, Seeds seeds, Judged& judged) {
  const Bound& bound = *judged.bound;
  judged.median = sum_of(rows, seeds, bound, bound.values, judged.seeds);
  if (judged.seeds == 0) {
    judged.median = Score::kNothing;
    return;
  }
  std::size_t ignored = 0;
  if (!bound.of.empty()) judged.worst = sum_of(rows, seeds, bound, bound.of, ignored);
  const bool is_enough = bound.of.empty() || judged.worst >= bound.median;
  judged.verdict = judged.median > 0.0 ? Verdict::missed : is_enough ? Verdict::met : Verdict::too_few;
}

void judge_between(const std::vector<double>& values, Judged& judged) {
  judged.median = judged.worst = floor::mean_of(values);
  if (std::isnan(judged.median)) return;  // no drive was long enough
  const Bound& bound = *judged.bound;
  const bool holds = judged.median >= bound.median && judged.median <= bound.worst;
  judged.verdict = holds ? Verdict::met : Verdict::missed;
}

/// Judges median and worst; of what is to be at least so much, mirrored.
void judge_spread(std::vector<double> values, Judged& judged) {
  const Bound& bound = *judged.bound;
  const double sign = bound.sense == Sense::at_least ? -1.0 : 1.0;
  for (double& value : values) value *= sign;
  const floor::MedianWorst spread = floor::median_worst(values);
  judged.median = sign * spread.median;
  judged.worst = sign * spread.worst;
  const bool median_holds = spread.median <= sign * bound.median;
  const bool worst_holds = std::isnan(bound.worst) || spread.worst <= sign * bound.worst;
  judged.verdict = median_holds && worst_holds ? Verdict::met : Verdict::missed;
}

bool is_not_refined(const Rows& rows, Seeds seeds, const Bound& bound) {
  if (bound.values.front().find("adjusted") == std::string::npos) return false;
  const std::vector<double> refined = values_in(rows, seeds, bound.trial, "refined");
  return std::any_of(refined.begin(), refined.end(), [](double is) { return is == 0.0; });
}

std::string asked_of(const Bound& bound) {
  const auto number = [&](double value) { return cell(value, bound.digits); };
  const std::string worst = std::isnan(bound.worst) ? "" : " (" + number(bound.worst) + ")";
  switch (bound.sense) {
    case Sense::at_most:
      return "<= " + number(bound.median) + worst;
    case Sense::at_least:
      return ">= " + number(bound.median) + worst;
    case Sense::between:
      return number(bound.median) + " .. " + number(bound.worst);
    case Sense::none:
      break;
  }
  return bound.of.empty() ? "none" : "none of >= " + cell(bound.median, 0);
}

}  // namespace

Seeds seeds_of(const std::string& trial, Seeds asked) {
  if (trial == trial::kFrames) return {0, 0};
  const std::uint64_t count = asked.last - asked.first + 1;
  // The spec asks for ten lines beside five of everything else.
  if (trial == trial::kLine && count > 1) return {asked.first, asked.last + count};
  return asked;
}

const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::met:
      return "met";
    case Verdict::missed:
      return "NOT MET";
    case Verdict::not_measured:
      return "not measured";
    case Verdict::not_refined:
      return "not refined";
    case Verdict::too_few:
      break;
  }
  return "too few";
}

std::vector<Judged> judge(const Rows& rows, Seeds seeds, const std::set<int>& asked_rows) {
  std::vector<Judged> all;
  for (const Bound& bound : bounds()) {
    if (!asked_rows.empty() && !asked_rows.contains(bound.row)) continue;
    Judged& judged = all.emplace_back();
    judged.bound = &bound;
    if (*bound.baseline != '\0')
      judged.baseline = floor::median_worst(values_in(rows, seeds, bound.trial, bound.baseline)).median;
    if (is_not_refined(rows, seeds, bound)) {
      judged.verdict = Verdict::not_refined;
      continue;
    }
    if (bound.sense == Sense::none) {
      judge_none(rows, seeds, judged);
      continue;
    }
    const std::vector<double> values = values_in(rows, seeds, bound.trial, bound.values.front());
    judged.seeds = values.size();
    if (values.empty()) continue;
    bound.sense == Sense::between ? judge_between(values, judged) : judge_spread(values, judged);
  }
  return all;
}

bool is_any_missed(const std::vector<Judged>& all) {
  return std::any_of(all.begin(), all.end(), [](const Judged& judged) {
    return judged.verdict == Verdict::missed || judged.verdict == Verdict::not_refined;
  });
}

std::string table_of(const std::vector<Judged>& all) {
  std::vector<std::vector<std::string>> rows = {
      {"row", "measure", "asked: median (worst)", "verdict", "median", "worst", "baseline", "seeds"}};
  for (const Judged& judged : all) {
    const Bound& bound = *judged.bound;
    const std::string unit = *bound.unit == '\0' ? "" : std::string(", ") + bound.unit;
    const int digits = bound.sense == Sense::none ? 0 : bound.digits;
    rows.push_back({std::to_string(bound.row), bound.measure + unit, asked_of(bound), to_string(judged.verdict),
                    cell(judged.median, digits), cell(judged.worst, digits), cell(judged.baseline, bound.digits),
                    std::to_string(judged.seeds)});
  }
  return markdown_table(rows, 4);
}

}  // namespace weft::evaluate::ceiling
