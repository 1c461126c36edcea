#include "server/traffic/plan/wished_berths.hpp"

#include <algorithm>

namespace weft::server {

std::uint32_t WishedBerths::who_touches(const BerthArc& arc, std::uint32_t robot) {
  for (const Berth berth : {arc.to, arc.middle}) {
    const std::vector<std::uint32_t>& robots = touched_by_.at(berth);
    const auto other =
        std::find_if(robots.begin(), robots.end(), [robot](std::uint32_t one) { return one != robot; });
    if (other != robots.end()) return *other;
  }
  return kNobody;
}

void WishedBerths::stay(Berth here, const std::vector<Berth>& beside, std::uint32_t robot) {
  wished_.at(here).robot = robot;
  touched_by_.at(here).push_back(robot);
  for (const Berth berth : beside) touched_by_.at(berth).push_back(robot);
}

void WishedBerths::drive(const BerthArc& arc, std::uint32_t robot) {
  wished_.at(arc.to).robot = robot;
  wished_.at(arc.middle).robot = robot;
  for (const Berth berth : arc.touches) touched_by_.at(berth).push_back(robot);
}

void WishedBerths::take_back(const BerthArc& arc, std::uint32_t robot) {
  // The robot that stands there may have been asked meanwhile, and have decided to stay.
  for (const Berth berth : {arc.to, arc.middle}) {
    if (wished_.at(berth).robot == robot) wished_.at(berth).robot = kNobody;
  }
  for (const Berth berth : arc.touches) std::erase(touched_by_.at(berth), robot);
}

void WishedBerths::forget_stay(Berth here, const std::vector<Berth>& beside, std::uint32_t robot) {
  if (wished_.at(here).robot == robot) wished_.at(here).robot = kNobody;
  std::erase(touched_by_.at(here), robot);
  for (const Berth berth : beside) std::erase(touched_by_.at(berth), robot);
}

void WishedBerths::forget_drive(const BerthArc& arc) {
  wished_.at(arc.to).robot = kNobody;
  wished_.at(arc.middle).robot = kNobody;
  touched_by_.at(arc.to).clear();
  for (const Berth berth : arc.touches) touched_by_.at(berth).clear();
}

}  // namespace weft::server
