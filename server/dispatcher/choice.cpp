#include "server/dispatcher/choice.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace weft::server {

Result<Choice> choose(std::vector<Candidate> candidates, const FindWay& find_way) {
  std::sort(candidates.begin(), candidates.end(),
            [](const Candidate& a, const Candidate& b) { return a.robot < b.robot; });
  std::optional<Choice> best;
  Error last = {ErrorCode::not_found, "no robot is idle and knows where it is"};
  for (const Candidate& candidate : candidates) {
    Result<Path> path = find_way(candidate);
    if (!path) {
      last = path.error();
      continue;
    }
    if (best && best->path.length_m <= path->length_m) continue;
    best = Choice{.robot = candidate.robot, .path = *std::move(path)};
  }
  if (!best) return fail(ErrorCode::not_found, last.message);
  return *std::move(best);
}

}  // namespace weft::server
