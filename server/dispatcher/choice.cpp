#include "server/dispatcher/choice.hpp"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

namespace weft::server {

Result<Choice> choose(std::vector<Candidate> candidates, const FindWay& find_way) {
  std::size_t left = std::numeric_limits<std::size_t>::max();
  return *Choosing().go_on(std::move(candidates), find_way, left);
}

void Choosing::look(const Candidate& candidate, const FindWay& find_way) {
  Known& known = known_[candidate.robot];
  known = {.candidate = candidate, .length_m = {}, .why = {}};
  Result<Path> path = find_way(candidate);
  if (!path) {
    known.why = path.error();
    return;
  }
  known.length_m = path->length_m;
  if (!best_ || path->length_m < best_->path.length_m) best_ = Choice{candidate.robot, *std::move(path)};
}

std::optional<Result<Choice>> Choosing::go_on(std::vector<Candidate> candidates, const FindWay& find_way,
                                              std::size_t& left) {
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.robot < b.robot; });
  const Candidate* best = nullptr;
  double best_m = 0.0;
  Error last = {ErrorCode::not_found, "no robot is idle and knows where it is"};
  for (const Candidate& candidate : candidates) {
    const auto found = known_.find(candidate.robot);
    if (found == known_.end() || found->second.candidate != candidate) {
      if (left == 0) return std::nullopt;
      --left;
      if (best_ && best_->robot == candidate.robot) best_.reset();
      look(candidate, find_way);
    }
    const Known& known = known_.at(candidate.robot);
    if (!known.length_m) {
      last = known.why;
    } else if (best == nullptr || *known.length_m < best_m) {
      best = &candidate;
      best_m = *known.length_m;
    }
  }
  if (best == nullptr) return fail(ErrorCode::not_found, last.message);
  if (best_ && best_->robot == best->robot) return *std::move(best_);
  // The one that was found on the way is no candidate any more.
  Result<Path> path = find_way(*best);
  if (!path) return fail(path.error());
  return Choice{best->robot, *std::move(path)};
}

std::set<RobotId> Choosing::refused() const {
  std::set<RobotId> robots;
  for (const auto& [robot, known] : known_) {
    if (!known.length_m && known.why.code == ErrorCode::refused) robots.insert(robot);
  }
  return robots;
}

}  // namespace weft::server
