#include "server/traffic/plan/lanes.hpp"

#include <algorithm>

namespace weft::server {
namespace {
/// Bounds how many berths are looked at ahead of one.
constexpr std::size_t kAhead = 120;
/// Is how many of them a robot can get to that has got away: lanes of up to some 80 m are seen. Where there are fewer
/// than kAhead, it needs all.
constexpr std::size_t kAway = 60;

bool touches(const BerthArc& arc, Berth berth) {
  return arc.to == berth || std::binary_search(arc.touches.begin(), arc.touches.end(), berth);
}
}  // namespace

/// Returns where one can drive from there without touching the occupied berth, the nearest first, itself included.
std::vector<Berth> Lanes::reached(const Stand& from, Berth occupied, std::size_t most) {
  ++searches_;
  std::vector<Berth> reached = {from.berth};
  seen_.at(from.berth) = searches_;
  for (std::size_t i = 0; i < reached.size() && reached.size() < most; ++i) {
    for (const BerthArc& arc : graph_.next(reached[i], from.methods)) {
      if (!graph_.is_cut(arc.to) || (occupied != kNoBerth && touches(arc, occupied))) continue;
      if (seen_.at(arc.to) == searches_) continue;
      seen_.at(arc.to) = searches_;
      from_.at(arc.to) = reached[i];
      reached.push_back(arc.to);
    }
  }
  return reached;
}

/// Returns the drives of the latest search from one berth to the other.
std::vector<const BerthArc*> Lanes::way_to(const Stand& from, Berth to) {
  std::vector<const BerthArc*> way;
  for (Berth here = to; here != from.berth; here = from_.at(here)) {
    const std::vector<BerthArc>& next = graph_.next(from_.at(here), from.methods);
    way.push_back(&*std::find_if(next.begin(), next.end(), [&](const BerthArc& arc) { return arc.to == here; }));
  }
  std::reverse(way.begin(), way.end());
  return way;
}

const Lanes::Ahead& Lanes::ahead(const Stand& stand) {
  const auto [entry, is_new] = ahead_.try_emplace(stand);
  Ahead& ahead = entry->second;
  if (!is_new) return ahead;
  const std::vector<Berth> free = reached(stand, kNoBerth, kAhead);
  ahead.is_small = free.size() < kAhead;
  ahead.enough = ahead.is_small ? free.size() : kAway;
  for (const Berth berth : free) {
    for (const BerthArc& arc : graph_.next(berth, stand.methods)) {
      if (!graph_.is_cut(arc.to)) continue;
      ahead.touched.insert(ahead.touched.end(), arc.touches.begin(), arc.touches.end());
    }
  }
  std::sort(ahead.touched.begin(), ahead.touched.end());
  ahead.touched.erase(std::unique(ahead.touched.begin(), ahead.touched.end()), ahead.touched.end());
  // Looks along one way out: a berth that shuts the robot in is touched on every way.
  for (const BerthArc* const arc : way_to(stand, free[ahead.enough - 1])) {
    bool is_any = false;
    for (const Berth occupied : arc->touches) {
      if (!graph_.is_cut(occupied) || is_beside(stand.berth, occupied)) continue;
      if (reached(stand, occupied, ahead.enough).size() >= ahead.enough) continue;
      is_any = true;
      ahead.shutting.push_back(occupied);
    }
    if (!is_any && !is_beside(stand.berth, arc->to)) break;
  }
  std::sort(ahead.shutting.begin(), ahead.shutting.end());
  ahead.shutting.erase(std::unique(ahead.shutting.begin(), ahead.shutting.end()), ahead.shutting.end());
  return ahead;
}

bool Lanes::is_beside(Berth one, Berth other) {
  const std::vector<Berth>& beside = graph_.beside(one);
  return std::binary_search(beside.begin(), beside.end(), other);
}

const std::vector<Berth>& Lanes::shut_in_by(const Stand& stand) {
  return ahead(stand).shutting;
}

bool Lanes::is_shut_in(const Stand& stand, Berth by) {
  const std::size_t enough = ahead(stand).enough;
  return reached(stand, by, enough).size() < enough;
}

bool Lanes::gets_past(const Stand& other, Berth here, Berth aside) {
  const std::size_t enough = ahead(other).enough;
  const std::vector<Berth> past = reached(other, aside, enough);
  return past.size() >= enough ||
         std::any_of(past.begin(), past.end(), [&](Berth berth) { return berth == here || is_beside(here, berth); });
}

/// Returns whether one that stands there can drive round to there again without touching the occupied berth.
bool Lanes::comes_round(const Stand& stand, Berth occupied) {
  const std::vector<Berth> berths = reached(stand, occupied, kAhead);
  return std::any_of(berths.begin(), berths.end(), [&](Berth berth) {
    const std::vector<BerthArc>& next = graph_.next(berth, stand.methods);
    return std::any_of(next.begin(), next.end(),
                       [&](const BerthArc& arc) { return arc.to == stand.berth && !touches(arc, occupied); });
  });
}

/// Returns whether the first robot, shut in by the other, can stand somewhere so that the other one gets past it:
/// away, or to where the first one was, there or farther on it does not shut in the first one: that gets away, or to
/// where the other one was, or can drive in a circle.
bool Lanes::lets_pass(const Stand& one, const Stand& other) {
  const std::size_t enough = ahead(other).enough;
  const std::vector<Berth> all_aside = reached(one, other.berth, kAhead);
  return std::any_of(all_aside.begin(), all_aside.end(), [&](Berth aside) {
    const std::vector<Berth> past = reached(other, aside, enough);
    if (past.size() >= enough) return true;
    const auto was_there = [&](Berth berth) { return berth == one.berth || is_beside(one.berth, berth); };
    const auto first = std::find_if(past.begin(), past.end(), was_there);
    const Stand stands = {aside, one.methods};
    const auto gets_on = [&](Berth berth) {
      return gets_past(stands, other.berth, berth) || comes_round(stands, berth);
    };
    return first != past.end() && (gets_on(*first) || gets_on(past.back()));
  });
}

bool Lanes::meet(const Stand& one, const Stand& other) {
  const auto [entry, is_new] = meet_[std::min(one, other)].try_emplace(std::max(one, other));
  if (is_new) {
    entry->second = is_shut_in(one, other.berth) && is_shut_in(other, one.berth) && !lets_pass(one, other) &&
                    !lets_pass(other, one);
  }
  return entry->second;
}

void Lanes::clear() {
  ahead_.clear();
  meet_.clear();
}

}  // namespace weft::server
