#include "agents/agent/missions/search_policy.hpp"

#include <chrono>

#include "agents/navigation/far_off.hpp"

namespace weft::agents {
namespace {
using namespace std::chrono_literals;

constexpr Duration kBetweenSearches = 10s;
}  // namespace

bool SearchPolicy::is_due(const Window& window, const Situation& situation, SteadyTime now) const {
  if (situation.is_out_of_order || now < search_at_ || window.places.empty()) return false;
  return is_of_use(window, situation);
}

bool SearchPolicy::is_of_use(const Window& window, const Situation& situation) const {
  const bool is_new = searched_at_ != window.revision;
  if (!situation.estimate.has_value()) return is_new || situation.has_route;
  if (situation.is_held) return false;
  return situation.strays || (is_new && !situation.has_route && is_far_off(situation.estimate->place_from_robot));
}

void SearchPolicy::begins(const Window& window, SteadyTime now) {
  searched_at_ = window.revision;
  search_at_ = now + kBetweenSearches;
}

}  // namespace weft::agents
