#include "tests/simulation/progress.hpp"

#include <utility>

namespace weft::simulation {
namespace {

constexpr double kTimesFree = 10.0;
constexpr double kBesides_s = 900.0;
constexpr double kYield_s = 180.0;

}  // namespace

std::vector<Progress::Late> Progress::look(SteadyTime now, const std::vector<GoalSight>& goals) {
  const Duration passed = looked_at_ ? now - *looked_at_ : Duration{};
  looked_at_ = now;
  std::map<GoalId, Known> before = std::exchange(known_, {});
  std::vector<Late> late;
  for (const GoalSight& goal : goals) {
    const auto was = before.find(goal.id);
    Known known = was == before.end() ? Known{} : was->second;
    if (was != before.end() && goal.counts) known.spent += passed;
    if (!known.free_s) known.free_s = goal.free_s;
    const bool is_yield = goal.kind == GoalKind::yield;
    const double most_s = is_yield ? kYield_s : kTimesFree * known.free_s.value_or(0.0) + kBesides_s;
    if (!known.is_told && seconds(known.spent) > most_s) {
      late.push_back({goal, seconds(known.spent), most_s});
      known.is_told = true;
    }
    known_[goal.id] = known;
  }
  return late;
}

}  // namespace weft::simulation
