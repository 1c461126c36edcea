#include "agents/agent/missions/taught_run.hpp"

#include <algorithm>

#include "core/names.hpp"

namespace weft::agents {

bool TaughtRun::joins(const Edge& edge) const {
  const ExperienceId from = edge.id.a.experience;
  const bool is_own = from == experience || std::find(others.begin(), others.end(), from) != others.end();
  if (edge.origin != Origin::stitch || edge.drivable == Drivable::none) return false;
  // A shortcut joins nothing: it has been driven another way, and no views were matched.
  return !is_own || (edge.id.a.experience == edge.id.b.experience && edge.inliers > 0);
}

void TaughtRun::count(const Kept& place) {
  ++kept;
  count(place.edges);
}

void TaughtRun::count(const std::vector<Edge>& edges) {
  for (const Edge& edge : edges)
    if (joins(edge)) joined.insert(edge.id.b);
}

Result<TaughtRun> new_run(const std::string& name, const std::vector<std::string>& methods, ExperienceIds& ids) {
  TaughtRun run;
  run.experience = ids.next();
  run.name = name;
  for (std::size_t i = 1; i < methods.size(); ++i) {
    run.others.push_back(ids.next());
    if (name_of_other(name, methods[i]).size() <= kLongestName) continue;
    return fail(ErrorCode::refused, "'" + name + "' is too long for a name to which -" + methods[i] +
                                        " is added: " + std::to_string(kLongestName) + " characters are the most");
  }
  return run;
}

std::string name_of_other(const std::string& name, const std::string& method) {
  return name.empty() ? std::string{} : name + "-" + method;
}

std::string summary(const TaughtRun& run) {
  const std::string places = std::to_string(run.kept) + (run.kept == 1 ? " place" : " places");
  std::string apart;
  for (const ExperienceId& other : run.told_apart)
    apart += (apart.empty() ? "; it looks like run " : ", ") + to_string(other);
  if (!apart.empty()) apart += ", and has been told apart from that by what lies around";
  return !run.joined.empty()
             ? places + ", " + std::to_string(run.joined.size()) +
                   " joined to what was taught before, or to its own beginning" + apart
             : places +
                   ", none joined to what was taught before, nor to its own beginning, in a way that can be driven" +
                   apart;
}

}  // namespace weft::agents
