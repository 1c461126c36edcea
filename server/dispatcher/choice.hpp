#pragma once
#include <set>
#include <string>
#include <vector>

#include "core/network/search.hpp"
#include "core/result.hpp"

namespace weft::server {

/// A robot that could take a goal: idle, reachable, and it knows where it stands.
struct Candidate {
  RobotId robot;
  PlaceId at;
  std::set<std::string> methods;  ///< what it can drive
  bool operator==(const Candidate&) const = default;
};

struct Choice {
  RobotId robot;
  Path path;
};

/// The candidate with the shortest route to the place; of equally long ones the one with the lowest id.
/// not_found: there is no candidate, or none of them can get there; the message says how far the last one gets.
Result<Choice> choose(const Snapshot& snapshot, std::vector<Candidate> candidates, const PlaceId& to);

}  // namespace weft::server
