#include "server/dispatcher/turns.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace weft::server {
namespace {
using namespace std::chrono_literals;
constexpr Duration kAgesEach = 2min;
}  // namespace

std::vector<const Goal*> Turns::in_turn(const std::vector<const Goal*>& goals, SteadyTime now) {
  std::map<GoalId, SteadyTime> still;
  std::vector<std::pair<std::int64_t, const Goal*>> classes;
  for (const Goal* const goal : goals) {
    const auto known = waits_since_.find(goal->id);
    const SteadyTime since = known == waits_since_.end() ? now : known->second;
    still.emplace(goal->id, since);
    classes.emplace_back(goal->priority + (now - since) / kAgesEach, goal);
  }
  waits_since_ = std::move(still);
  std::ranges::stable_sort(classes, std::ranges::greater{}, &std::pair<std::int64_t, const Goal*>::first);
  std::vector<const Goal*> ordered;
  ordered.reserve(classes.size());
  for (const auto& [urgency, goal] : classes) ordered.push_back(goal);
  return ordered;
}

}  // namespace weft::server
