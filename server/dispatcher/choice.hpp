#pragma once
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "core/network/search.hpp"
#include "core/result.hpp"

namespace weft::server {

/// Describes a robot that could take a goal: idle, reachable, and it knows where it stands.
struct Candidate {
  RobotId robot;
  PlaceId at;
  std::set<std::string> methods;  ///< what it can drive
  bool keeps_limits = false;
  std::optional<int> percent{};  ///< of its charge; none: it is not known, or does not count
  bool operator==(const Candidate&) const = default;
};

struct Choice {
  RobotId robot;
  Path path;
};

/// Finds the shortest way of a candidate to where it is to go, or tells why there is none.
using FindWay = std::function<Result<Path>(const Candidate&)>;

/// Returns the candidate with the shortest way; of equally long ones the one with the lowest id. not_found: there is
/// no candidate, or none of them can get there; the message says how far the last one gets.
Result<Choice> choose(std::vector<Candidate> candidates, const FindWay& find_way);

}  // namespace weft::server
