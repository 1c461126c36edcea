#include "agents/agent/missions/stray_policy.hpp"

namespace weft::agents {
namespace {
constexpr int kMostTimes = 3;
}  // namespace

void StrayPolicy::look(Following following, std::string_view reason) {
  strays_ = following == Following::stopped && (reason == "off_route" || reason == "route_not_joined");
}

bool StrayPolicy::gives_back(const GoalId& goal) {
  if (!strays_) return false;
  times_ = goal == given_back_ ? times_ + 1 : 1;
  given_back_ = goal;
  if (times_ > kMostTimes) return false;
  strays_ = false;
  return true;
}

}  // namespace weft::agents
