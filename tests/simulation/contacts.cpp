#include "tests/simulation/contacts.hpp"

#include <algorithm>

namespace weft::simulation {
namespace {

constexpr double kApart_m = 0.1;  // so far from one another two bodies are not together any more

}  // namespace

bool Contacts::is_by_hand(const RobotId& a, const RobotId& b) const {
  return by_hand_.contains(std::minmax(a, b)) || put_down_.contains({a, b}) || put_down_.contains({b, a});
}

std::vector<Contacts::Touch> Contacts::moved(const RobotId& robot, const Stance& now) {
  bodies_[robot] = now;
  if (now.drives || now.led) std::erase_if(put_down_, [&](const Pair& pair) { return pair.first == robot; });
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
    if (gap < 0.0 && (now.drives || other.drives) && !is_by_hand(robot, id)) touches.push_back({id, gap});
  }
  return touches;
}

}  // namespace weft::simulation
