#include "server/dispatcher/standstills.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

namespace weft::server {
namespace {
using namespace std::chrono_literals;

constexpr Duration kBetweenWaitGraphs = 500ms;
/// Bounds from below how long a standstill lasts before it is named: what ends by itself meanwhile is none.
constexpr Duration kLasts = 1s;
constexpr Duration kToldAgainAfter = 10min;
constexpr std::size_t kMostLinks = 12;

std::string is_what(Stays stays) {
  switch (stays) {
    case Stays::idle:
      return "is idle";
    case Stays::paused:
      return "is stopped";
    case Stays::stopped:
      return "is stopped by its base";
    case Stays::held:
      return "is held";
    case Stays::ruled:
      return "is kept from going on by a rule";
    case Stays::blocked:
      return "is asked to drive and does not move";
    case Stays::lost:
      return "does not know where it is";
    case Stays::faulted:
      return "cannot work";
    case Stays::silent:
      return "is not heard";
    case Stays::no_way:
      return "has no way to its goal";
  }
  return {};
}

std::string what_helps(Stays stays, const std::string& name) {
  switch (stays) {
    case Stays::idle:
      return "send it elsewhere: weft goal send --to LABEL --robot " + name;
    case Stays::paused:
      return "weft resume " + name;
    case Stays::ruled:
      return "see weft goal why " + name + " for the rule; weft rule remove RULE lets it on";
    case Stays::stopped:
      return "look what stops it; after an emergency stop weft resume " + name;
    case Stays::held:
      return "weft unhold " + name;
    case Stays::blocked:
      return "see what holds it";
    case Stays::lost:
      return "weft localise " + name + " --at LABEL, or lead it to where it was taught";
    case Stays::faulted:
    case Stays::no_way:
      return "see weft goal why " + name;
    case Stays::silent:
      return "start its agent, or take it off the floor and then weft robot clear " + name;
  }
  return {};
}

}  // namespace

std::vector<Standstill> Standstills::look() {
  const std::vector<Wait> waits = dispatcher_.waits();
  waits_.clear();
  for (const Wait& wait : waits) waits_.emplace(wait.robot, wait);
  std::map<RobotId, Stays> stays;
  const auto add = [&](const RobotId& robot) {
    if (const std::optional<Stays> why = dispatcher_.stays(robot)) stays.emplace(robot, *why);
  };
  for (const Wait& wait : waits) {
    add(wait.robot);
    for (const RobotId& holder : wait.held_by) add(holder);
  }
  return standstills(waits, stays);
}

void Standstills::tick(Now now) {
  if (looked_at_ && now.steady < *looked_at_ + kBetweenWaitGraphs) return;
  if (!dispatcher_.has_assignments() && known_.empty() && waits_.empty()) return;
  looked_at_ = now.steady;
  std::map<Key, Known> before = std::exchange(known_, {});
  of_.clear();
  const std::vector<Standstill> all = look();
  for (const Standstill& standstill : all) {
    const Key key{standstill.core, standstill.stays};
    const auto was = before.find(key);
    Known& known = known_[key] =
        was == before.end() ? Known{.since = now.steady, .told_at = {}, .text = {}} : was->second;
    if (was != before.end()) before.erase(was);
    if (now.steady - known.since >= kLasts) name(standstill, known, now);
    for (const RobotId& robot : standstill.core) of_.emplace(robot, key);
  }
  for (const Standstill& standstill : all) {
    for (const RobotId& robot : standstill.behind) of_.emplace(robot, Key{standstill.core, standstill.stays});
  }
  for (const auto& [key, known] : before) {
    if (known.told_at) note("traffic.standstill_over", key.core.front(), "it is over: " + names_of(key.core), now);
  }
}

void Standstills::name(const Standstill& standstill, Known& known, Now now) {
  known.text = text(standstill);
  if (known.told_at && now.steady < *known.told_at + kToldAgainAfter) return;
  known.told_at = now.steady;
  note("traffic.standstill", standstill.core.front(), known.text, now);
}

void Standstills::note(const char* kind, const RobotId& robot, const std::string& cause, Now now) {
  const Goal* const goal = dispatcher_.goal_of(robot);
  context_.writer.note({.at = {},
                        .kind = kind,
                        .robot = robot,
                        .goal = goal != nullptr ? goal->id : GoalId{},
                        .cause = clipped(cause),
                        .who = "traffic"},
                       now);
}

std::optional<SteadyTime> Standstills::next() const {
  if (!looked_at_ || (!dispatcher_.has_assignments() && known_.empty() && waits_.empty())) return std::nullopt;
  return *looked_at_ + kBetweenWaitGraphs;
}

const Wait* Standstills::wait_of(const RobotId& robot) const {
  const auto found = waits_.find(robot);
  return found == waits_.end() ? nullptr : &found->second;
}

std::string Standstills::text_of(const RobotId& robot) const {
  const auto found = of_.find(robot);
  return found == of_.end() ? std::string() : known_.at(found->second).text;
}

std::string Standstills::names_of(const std::vector<RobotId>& robots) const {
  std::string names;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const char* const before = i == 0 ? "" : i + 1 == robots.size() ? " and " : ", ";
    names += before + fleet_.name_of(robots[i]);
  }
  return names;
}

std::string Standstills::text(const Standstill& standstill) const {
  if (standstill.stays) return why_it_stays(standstill);
  std::string text = names_of(standstill.core) + " wait for one another (" + std::to_string(standstill.core.size()) +
                     " robots)" + links(standstill);
  if (!standstill.behind.empty()) text += "; behind them: " + names_of(standstill.behind);
  return text +
         ". Lead one of them back out of the others' way, or end the goal of one that can be sent another way: "
         "weft goal cancel ID";
}

std::string Standstills::why_it_stays(const Standstill& standstill) const {
  const std::string name = fleet_.name_of(standstill.core.front());
  return name + " " + is_what(*standstill.stays) + " and in the way of " + names_of(standstill.behind) +
         links(standstill) + "; what helps: " + what_helps(*standstill.stays, name);
}

/// Returns who needs which place, for people.
std::string Standstills::links(const Standstill& standstill) const {
  std::vector<RobotId> robots = standstill.core;
  robots.insert(robots.end(), standstill.behind.begin(), standstill.behind.end());
  std::string text;
  std::size_t told = 0;
  for (const RobotId& robot : robots) {
    const Wait* const wait = wait_of(robot);
    if (wait == nullptr || !wait->needs || told++ >= kMostLinks) continue;
    text += (text.empty() ? ": " : "; ") + fleet_.name_of(robot) + " at " + to_string(wait->at) + " needs " +
            to_string(wait->needs) + ", which " +
            names_of(std::vector<RobotId>(wait->held_by.begin(), wait->held_by.end())) +
            (wait->held_by.size() > 1 ? " hold" : " holds");
  }
  return text;
}

std::size_t Standstills::count() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(known_, [](const auto& entry) { return !entry.second.text.empty(); }));
}

}  // namespace weft::server
