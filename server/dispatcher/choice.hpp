#pragma once
#include <cstddef>
#include <functional>
#include <map>
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

/// Chooses as `choose` does, with a few searches at a time: remembers how far candidates have it, as long as they are
/// the same and stand where they did. For one goal on one map.
class Choosing {
 public:
  /// Searches ways of candidates that were not looked at yet, `left` of these at most, which it lowers by what it
  /// searched. None: it was not enough, and is to be called again.
  std::optional<Result<Choice>> go_on(std::vector<Candidate> candidates, const FindWay& find_way, std::size_t& left);
  /// Returns the robots whose way was refused, though there is one.
  std::set<RobotId> refused() const;

 private:
  struct Known {
    Candidate candidate;
    std::optional<double> length_m;  ///< none: there is no way
    Error why;
  };
  void look(const Candidate& candidate, const FindWay& find_way);

  std::map<RobotId, Known> known_;
  std::optional<Choice> best_;  ///< of those looked at since it was found
};

}  // namespace weft::server
