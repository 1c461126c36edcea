#include "tests/simulation/contacts.hpp"

#include <algorithm>

namespace weft::simulation {
namespace {

constexpr double kApart_m = 0.1;  // so far from one another two bodies are not together any more

}  // namespace

std::vector<Contacts::Touch> Contacts::moved(const RobotId& robot, const Stance& now) {
  bodies_[robot] = now;
  std::vector<Touch> touches;
  for (const auto& [id, other] : bodies_) {
    if (id == robot) continue;
    const Pair pair = std::minmax(robot, id);
    const double gap = (now.at - other.at).norm() - now.radius_m - other.radius_m;
    if (gap > kApart_m) {
      by_hand_.erase(pair);
    } else if (now.led || other.led) {
      by_hand_.insert(pair);
    }
    if (gap < 0.0 && (now.drives || other.drives) && !by_hand_.contains(pair)) touches.push_back({id, gap});
  }
  return touches;
}

}  // namespace weft::simulation
