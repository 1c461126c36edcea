#include "server/traffic/plan/safe_states.hpp"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

namespace weft::server {

void SafeStates::add(const Lanes::Stand& at, bool is_gridlocked) {
  robots_.push_back(at);
  ways_out_.emplace_back();
  is_gridlocked_.push_back(is_gridlocked);
  is_away_.push_back(false);
  arcs_.occupy(at.berth);
}

namespace {
bool has(const std::vector<bool>& berths, Berth berth) {
  return berth < berths.size() && berths[berth];
}
void add_to(std::vector<bool>& berths, Berth berth) {
  if (berth >= berths.size()) berths.resize(2 * (berth + std::size_t{1}));
  berths[berth] = true;
}
}  // namespace

void SafeStates::put(std::uint32_t robot, Berth at) {
  if (robots_[robot].berth == at) return;
  place(robot, at);
  ways_out_[robot].is_known = false;
  forget_ways_over(at);
}

/// Forgets ways out that lead over the berth, where somebody is now.
void SafeStates::forget_ways_over(Berth berth) {
  for (WaysOut& ways : ways_out_) ways.is_known = ways.is_known && !has(ways.touched, berth);
}

void SafeStates::place(std::uint32_t robot, Berth at) {
  const Berth from = std::exchange(robots_[robot].berth, at);
  if (is_away_[robot]) return;
  arcs_.vacate(from);
  arcs_.occupy(at);
}

void SafeStates::set_away(std::uint32_t robot, bool is_away) {
  if (is_away_[robot] == is_away) return;
  is_away_[robot] = is_away;
  if (is_away) {
    arcs_.vacate(robots_[robot].berth);
  } else {
    arcs_.occupy(robots_[robot].berth);
  }
}

/// Leaves a robot out of what is occupied for as long as it lives: nobody is in its own way.
class SafeStates::OthersOnly {
 public:
  OthersOnly(SafeStates& states, std::uint32_t robot)
      : states_(states), robot_(robot), was_away_(states.is_away_[robot]) {
    states_.set_away(robot_, true);
  }
  OthersOnly(const OthersOnly&) = delete;
  OthersOnly& operator=(const OthersOnly&) = delete;
  ~OthersOnly() { states_.set_away(robot_, was_away_); }

 private:
  SafeStates& states_;
  std::uint32_t robot_;
  bool was_away_;
};

/// Returns whether the robot gets away past those that are not away yet. In a small network nobody does, and it is
/// looked at pairs only: see `Meetings`.
bool SafeStates::gets_away(std::uint32_t robot, std::vector<bool>* touched, std::vector<Berth>* blocked_at) {
  const Lanes::Stand stand = robots_[robot];
  const Lanes::Ahead& ahead = lanes_.ahead(stand);
  if (ahead.is_small) return true;
  ++searches_;
  const OthersOnly others(*this, robot);
  std::vector<Berth>& reached = reached_;
  reached.assign(1, stand.berth);
  seen_.at(stand.berth) = searches_;
  for (std::size_t i = 0; i < reached.size() && reached.size() < ahead.enough; ++i) {
    for (const OccupiedArcs::Arc& arc : arcs_.next(reached[i], stand.methods)) {
      if (seen_.at(arc.to) == searches_) continue;
      if (arc.occupants > 0) {
        if (blocked_at != nullptr) blocked_at->push_back(arcs_.occupied_on(arc));
        continue;
      }
      seen_.at(arc.to) = searches_;
      from_.at(arc.to) = reached[i];
      reached.push_back(arc.to);
      if (touched == nullptr) continue;
      for (const Berth berth : arc.touches) add_to(*touched, berth);
    }
  }
  return reached.size() >= ahead.enough;
}

std::vector<Berth> SafeStates::way_out(std::uint32_t robot, std::size_t most) {
  const Berth from = robots_[robot].berth;
  if (from == kNoBerth || !gets_away(robot, nullptr) || lanes_.ahead(robots_[robot]).is_small) return {};
  std::vector<Berth> way;
  for (Berth berth = reached_.back(); berth != from; berth = from_.at(berth)) way.push_back(berth);
  std::reverse(way.begin(), way.end());
  way.resize(std::min(way.size(), most));
  while (!way.empty() && !stuck_by(robot, way.back(), {}).empty()) way.pop_back();
  return way;
}

bool SafeStates::is_way_out(std::uint32_t robot, const std::vector<Berth>& over) {
  const Lanes::Stand stand = robots_[robot];
  Berth here = stand.berth;
  const auto is_free = [&](Berth to) {
    const std::span<const OccupiedArcs::Arc> next = arcs_.next(std::exchange(here, to), stand.methods);
    const auto arc = std::ranges::find(next, to, &OccupiedArcs::Arc::to);
    return arc != next.end() && arc->occupants == 0;
  };
  const auto are_free = [&] {
    const OthersOnly others(*this, robot);
    return std::ranges::all_of(over, is_free);
  };
  return are_free() && stuck_by(robot, here, {}).empty();
}

/// Returns whom it concerns that the robot stands there: itself, and whose ways out lead by.
std::vector<std::uint32_t> SafeStates::concerned(std::uint32_t by, Berth berth) const {
  std::vector<std::uint32_t> robots = {by};
  for (std::uint32_t robot = 0; robot < robots_.size(); ++robot) {
    if (robot == by || robots_[robot].berth == kNoBerth) continue;
    const std::vector<Berth>& touched = lanes_.ahead(robots_[robot]).touched;
    if (std::binary_search(touched.begin(), touched.end(), berth)) robots.push_back(robot);
  }
  return robots;
}

/// Looks for ways out past all others where they are, unless some are known.
void SafeStates::look(std::uint32_t robot) {
  WaysOut& ways = ways_out_[robot];
  if (ways.is_known) return;
  ways.touched.assign(graph_.size(), false);
  ways.is_known = gets_away(robot, &ways.touched);
}

/// Returns whether the robot gets away, and has it away then.
bool SafeStates::leaves(std::uint32_t robot, std::vector<std::uint32_t>& away) {
  if (is_away_[robot]) return true;
  const WaysOut& ways = ways_out_[robot];
  const bool is_sure = ways.is_known && !has(ways.touched, taken_);
  if (!is_sure && !gets_away(robot, nullptr)) return false;
  away.push_back(robot);
  set_away(robot, true);
  return true;
}

/// Returns whether the robot gets away once some of those have that block its ways, and those that block theirs.
/// False: that is not known. Has those away that do.
bool SafeStates::leaves_after_others(std::uint32_t robot, std::vector<std::uint32_t>& away,
                                     std::vector<bool>& is_tried) {
  is_tried[robot] = true;
  std::vector<Berth> blocked_at;
  for (bool has_changed = true; std::exchange(has_changed, false);) {
    blocked_at.clear();
    if (gets_away(robot, nullptr, &blocked_at)) {
      away.push_back(robot);
      set_away(robot, true);
      return true;
    }
    for (std::uint32_t other = 0; other < robots_.size() && !has_changed; ++other) {
      const bool blocks = !is_tried[other] && !is_away_[other] &&
                          std::find(blocked_at.begin(), blocked_at.end(), robots_[other].berth) != blocked_at.end();
      has_changed = blocks && leaves_after_others(other, away, is_tried);
    }
  }
  return false;
}

/// Returns which of the robots, and of those in their way, cannot get away, sorted.
std::vector<std::uint32_t> SafeStates::stuck_around(std::vector<std::uint32_t> robots) {
  std::vector<bool> is_known(robots_.size(), false);
  for (const std::uint32_t robot : robots) is_known[robot] = true;
  std::vector<std::uint32_t> stuck;
  std::vector<std::uint32_t> away;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    if (leaves(robots[i], away)) continue;
    stuck.push_back(robots[i]);
    const std::vector<Berth>& touched = lanes_.ahead(robots_[robots[i]]).touched;
    for (std::uint32_t other = 0; other < robots_.size(); ++other) {
      const bool is_there = !is_known[other] && robots_[other].berth != kNoBerth;
      if (!is_there || !std::binary_search(touched.begin(), touched.end(), robots_[other].berth)) continue;
      is_known[other] = true;
      robots.push_back(other);
    }
  }
  while (std::erase_if(stuck, [&](std::uint32_t robot) { return leaves(robot, away); }) > 0) {
  }
  for (const std::uint32_t robot : away) set_away(robot, false);
  std::sort(stuck.begin(), stuck.end());
  return stuck;
}

std::vector<std::uint32_t> SafeStates::stuck_by(std::uint32_t robot, Berth to,
                                                const std::vector<std::uint32_t>& leaving) {
  for (const std::uint32_t other : leaving) set_away(other, true);
  std::vector<std::uint32_t> newly;
  const Gets gets = gets_from(robot, to);
  if (gets != Gets::away) newly = newly_stuck(robot, to);
  for (const std::uint32_t other : leaving) {
    set_away(other, false);
    forget_ways_over(robots_[other].berth);
  }
  if (newly.size() == 1 && newly.front() == robot) newly = with_blockers(robot, to);
  if (gets == Gets::on) std::erase_if(newly, [&](std::uint32_t other) { return is_gridlocked_[other]; });
  return newly;
}

/// Tells how far the robot would get from there, others first. When it gets away nobody else is stuck by that: once
/// it is away there are only the others, as if it had not come.
SafeStates::Gets SafeStates::gets_from(std::uint32_t robot, Berth to) {
  const Berth from = robots_[robot].berth;
  std::vector<std::uint32_t> away;
  std::vector<bool> is_tried(robots_.size(), false);
  place(robot, to);
  Gets gets = leaves_after_others(robot, away, is_tried) ? Gets::away : Gets::nowhere;
  if (gets == Gets::nowhere && is_gridlocked_[robot]) {
    gets_away(robot, nullptr);
    if (2 * reached_.size() >= lanes_.ahead(robots_[robot]).enough) gets = Gets::on;
  }
  for (const std::uint32_t other : away) set_away(other, false);
  place(robot, from);
  return gets;
}

/// Returns the robot and those that block its ways from there, sorted.
std::vector<std::uint32_t> SafeStates::with_blockers(std::uint32_t robot, Berth to) {
  const Berth from = robots_[robot].berth;
  std::vector<Berth> blocked_at;
  place(robot, to);
  gets_away(robot, nullptr, &blocked_at);
  place(robot, from);
  std::vector<std::uint32_t> robots;
  for (std::uint32_t other = 0; other < robots_.size(); ++other) {
    const auto at = std::find(blocked_at.begin(), blocked_at.end(), robots_[other].berth);
    if (other == robot || at != blocked_at.end()) robots.push_back(other);
  }
  return robots;
}

std::vector<std::uint32_t> SafeStates::newly_stuck(std::uint32_t robot, Berth to) {
  const Berth from = robots_[robot].berth;
  std::vector<std::uint32_t> concerned = this->concerned(robot, to);
  for (const std::uint32_t other : concerned) {
    if (other != robot) look(other);
  }
  const WaysOut ways = std::exchange(ways_out_[robot], {});
  place(robot, to);
  taken_ = to;
  const std::vector<std::uint32_t> after = stuck_around(std::move(concerned));
  place(robot, from);
  taken_ = kNoBerth;
  ways_out_[robot] = ways;
  if (after.empty()) return {};
  const std::vector<std::uint32_t> before = stuck_around(after);
  std::vector<std::uint32_t> newly;
  std::set_difference(after.begin(), after.end(), before.begin(), before.end(), std::back_inserter(newly));
  return newly;
}

bool SafeStates::concern(std::uint32_t robot, Berth to, const Lanes::Stand& other) {
  const auto comes_by = [this](const Lanes::Stand& stand, Berth berth) {
    const std::vector<Berth>& touched = lanes_.ahead(stand).touched;
    return std::binary_search(touched.begin(), touched.end(), berth);
  };
  return comes_by({to, robots_[robot].methods}, other.berth) || comes_by(other, to);
}

/// Returns whether a robot that stands there is at one of the berths, which are sorted; who stands between two
/// berths where one may stop is at those beside it.
bool SafeStates::is_at_any(const std::vector<Berth>& berths, Berth at) {
  const auto is_one = [&](Berth berth) { return std::binary_search(berths.begin(), berths.end(), berth); };
  return graph_.is_cut(at) ? is_one(at) : std::ranges::any_of(graph_.beside(at), is_one);
}

std::vector<std::uint32_t> SafeStates::kept_by(std::uint32_t robot, Berth to) {
  const Lanes::Stand here = robots_[robot];
  const Lanes::Stand there = {to, here.methods};
  const std::vector<Berth>& shutting = lanes_.shut_in_by(there);
  std::vector<std::uint32_t> met;
  for (std::uint32_t other = 0; other < robots_.size() && !shutting.empty(); ++other) {
    const Lanes::Stand& stand = robots_[other];
    const bool are_gridlocked = is_gridlocked_[robot] && is_gridlocked_[other];
    if (other == robot || stand.berth == kNoBerth || are_gridlocked || !is_at_any(shutting, stand.berth)) continue;
    if (lanes_.meet(there, stand) && !lanes_.meet(here, stand)) met.push_back(other);
  }
  return met.empty() ? stuck_by(robot, to, {}) : met;
}

}  // namespace weft::server
