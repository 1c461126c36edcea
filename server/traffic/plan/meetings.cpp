#include "server/traffic/plan/meetings.hpp"

#include <algorithm>
#include <map>

namespace weft::server {

template <class Visit>
void Meetings::for_each_cut(Berth berth, Visit&& visit) {
  if (berth == kNoBerth) return;
  if (graph_.is_cut(berth)) return visit(berth);
  for (const Berth beside : graph_.beside(berth)) {
    if (graph_.is_cut(beside)) visit(beside);
  }
}

void Meetings::add(Berth at, std::uint32_t methods) {
  const auto robot = static_cast<std::uint32_t>(robots_.size());
  robots_.push_back({{at, methods}, 0});
  wishes(robot, at);
}

void Meetings::wishes(std::uint32_t robot, Berth to) {
  for_each_cut(to, [&](Berth cut) { near_.at(cut).push_back({robot, to, 0}); });
}

void Meetings::erase(std::uint32_t robot, Berth berth) {
  for_each_cut(berth, [&](Berth cut) {
    std::erase_if(near_.at(cut), [&](const Near& near) { return near.robot == robot && near.berth == berth; });
  });
}

void Meetings::moves(std::uint32_t robot, Berth to) {
  Known& known = robots_[robot];
  const Berth from = known.at.berth;
  ++known.moves;
  for_each_cut(from, [&](Berth cut) { left_.at(cut).push_back({robot, from, known.moves}); });
  erase(robot, from);
  known.at.berth = to;
  wishes(robot, to);
}

/// Returns whether the robot would meet the other one there, and does not where it stands.
bool Meetings::meets(std::uint32_t robot, Berth to, std::uint32_t other, Berth at) {
  if (other == robot) return false;
  const Lanes::Stand stand{at, robots_[other].at.methods};
  return lanes_.meet({to, robots_[robot].at.methods}, stand) && !lanes_.meet(robots_[robot].at, stand);
}

std::vector<std::uint32_t> Meetings::refuse(std::uint32_t robot, Berth to) {
  std::vector<std::uint32_t> met;
  for (const Berth cut : lanes_.shut_in_by({to, robots_[robot].at.methods})) {
    for (const Near& near : near_.at(cut)) {
      if (meets(robot, to, near.robot, near.berth)) met.push_back(near.robot);
    }
  }
  for (const auto& [other, at] : refused_) {
    if (meets(robot, to, other, at)) met.push_back(other);
  }
  std::sort(met.begin(), met.end());
  met.erase(std::unique(met.begin(), met.end()), met.end());
  if (!met.empty()) refused_.push_back({robot, to});
  return met;
}

bool Meetings::would_keep_from(const Lanes::Stand& at, const Meeting& other) {
  const std::vector<Berth>& beside = graph_.beside(other.to);
  return at.berth == other.to || std::binary_search(beside.begin(), beside.end(), at.berth) ||
         lanes_.meet({other.to, robots_[other.robot].at.methods}, at);
}

std::vector<MovesFirst> Meetings::first(std::uint32_t robot, Berth to) {
  std::map<std::uint32_t, std::uint32_t> latest;
  for (const Berth cut : lanes_.shut_in_by({to, robots_[robot].at.methods})) {
    const std::vector<Near>* const left = left_.find(cut);
    if (left == nullptr) continue;
    for (const Near& near : *left) {
      std::uint32_t& moves = latest[near.robot];
      if (near.moves > moves && meets(robot, to, near.robot, near.berth)) moves = near.moves;
    }
  }
  std::vector<MovesFirst> first;
  for (const auto& [other, moves] : latest) {
    if (moves > 0) first.push_back({other, moves});
  }
  return first;
}

}  // namespace weft::server
