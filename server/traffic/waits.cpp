#include "server/traffic/waits.hpp"

#include <algorithm>
#include <deque>
#include <utility>

namespace weft::server {
namespace {

/// Holds for whom each robot waits; one that stays waits for nobody.
using Graph = std::map<RobotId, std::set<RobotId>>;

/// Finds strongly connected parts by Tarjan's search (1972), without recursion.
class StrongParts {
 public:
  explicit StrongParts(const Graph& graph) : graph_(graph) {
    for (const auto& [robot, holders] : graph_) {
      if (!marks_.contains(robot)) search(robot);
    }
  }
  std::vector<std::vector<RobotId>> take() { return std::move(parts_); }

 private:
  struct Mark {
    std::size_t number = 0;
    std::size_t lowest = 0;
    bool is_open = true;
  };
  struct Step {
    RobotId robot;
    std::set<RobotId>::const_iterator next;
  };

  void enter(const RobotId& robot) {
    marks_[robot] = {.number = count_, .lowest = count_};
    ++count_;
    open_.push_back(robot);
    path_.push_back({robot, graph_.at(robot).begin()});
  }
  void search(const RobotId& root) {
    enter(root);
    while (!path_.empty()) {
      Step& step = path_.back();
      Mark& mark = marks_.at(step.robot);
      if (step.next == graph_.at(step.robot).end()) {
        leave();
        continue;
      }
      const RobotId next = *step.next++;
      if (!graph_.contains(next)) continue;
      const auto known = marks_.find(next);
      if (known == marks_.end()) {
        enter(next);
      } else if (known->second.is_open) {
        mark.lowest = std::min(mark.lowest, known->second.number);
      }
    }
  }
  void leave() {
    const RobotId robot = path_.back().robot;
    path_.pop_back();
    const Mark mark = marks_.at(robot);
    if (!path_.empty()) {
      Mark& before = marks_.at(path_.back().robot);
      before.lowest = std::min(before.lowest, mark.lowest);
    }
    if (mark.lowest != mark.number) return;
    std::vector<RobotId> part;
    do {
      part.push_back(open_.back());
      marks_.at(open_.back()).is_open = false;
      open_.pop_back();
    } while (part.back() != robot);
    std::sort(part.begin(), part.end());
    parts_.push_back(std::move(part));
  }

  const Graph& graph_;
  std::map<RobotId, Mark> marks_;
  std::vector<RobotId> open_;
  std::vector<Step> path_;
  std::vector<std::vector<RobotId>> parts_;
  std::size_t count_ = 0;
};

/// Returns the shortest cycle through the first robot of the part, then what else is in the part.
std::vector<RobotId> as_cycle(const std::vector<RobotId>& part, const Graph& graph) {
  const std::set<RobotId> members(part.begin(), part.end());
  std::map<RobotId, RobotId> came_from;
  std::deque<RobotId> open = {part.front()};
  while (!open.empty() && !came_from.contains(part.front())) {
    const RobotId here = open.front();
    open.pop_front();
    for (const RobotId& next : graph.at(here)) {
      if (members.contains(next) && came_from.emplace(next, here).second) open.push_back(next);
    }
  }
  std::vector<RobotId> cycle = {part.front()};
  for (RobotId at = came_from.at(part.front()); at != part.front(); at = came_from.at(at)) cycle.push_back(at);
  std::reverse(cycle.begin() + 1, cycle.end());
  const std::set<RobotId> named(cycle.begin(), cycle.end());
  std::set_difference(members.begin(), members.end(), named.begin(), named.end(), std::back_inserter(cycle));
  return cycle;
}

std::vector<RobotId> behind(const std::vector<RobotId>& core, const Graph& waiters) {
  std::set<RobotId> seen(core.begin(), core.end());
  std::deque<RobotId> open(core.begin(), core.end());
  std::vector<RobotId> found;
  while (!open.empty()) {
    const auto of_here = waiters.find(open.front());
    open.pop_front();
    if (of_here == waiters.end()) continue;
    for (const RobotId& waiter : of_here->second) {
      if (!seen.insert(waiter).second) continue;
      found.push_back(waiter);
      open.push_back(waiter);
    }
  }
  return found;
}

}  // namespace

std::vector<Standstill> standstills(const std::vector<Wait>& waits, const std::map<RobotId, Stays>& stays) {
  Graph graph;
  Graph waiters;
  for (const Wait& wait : waits) {
    if (stays.contains(wait.robot)) continue;
    graph[wait.robot] = wait.held_by;
    for (const RobotId& holder : wait.held_by) waiters[holder].insert(wait.robot);
  }
  std::vector<Standstill> found;
  for (const std::vector<RobotId>& part : StrongParts(graph).take()) {
    if (part.size() < 2) continue;
    const std::vector<RobotId> cycle = as_cycle(part, graph);
    found.push_back({.core = cycle, .stays = {}, .behind = behind(cycle, waiters)});
  }
  for (const auto& [robot, why] : stays) {
    if (!waiters.contains(robot)) continue;
    found.push_back({.core = {robot}, .stays = why, .behind = behind({robot}, waiters)});
  }
  std::sort(found.begin(), found.end(), [](const Standstill& a, const Standstill& b) { return a.core < b.core; });
  return found;
}

}  // namespace weft::server
