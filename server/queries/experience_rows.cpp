#include "server/queries/experience_rows.hpp"

#include <algorithm>
#include <set>

#include "core/network/way_on.hpp"

namespace weft::server {
namespace {

void tell_joined(const Experience& experience, msg::ExperienceRow& row) {
  std::set<ExperienceId> joined;
  for (const Edge& edge : experience.stitches) {
    for (const ExperienceId end : {edge.id.a.experience, edge.id.b.experience}) {
      if (end != experience.id) joined.insert(end);
    }
  }
  row.joined_count = static_cast<std::uint32_t>(joined.size());
  row.joined.assign(joined.begin(), joined.end());
  row.joined.resize(std::min(row.joined.size(), msg::kJoinedTold));
}

}  // namespace

std::vector<msg::ExperienceRow> experience_rows(const Snapshot& map, const std::map<ExperienceId, WallTime>& begun) {
  std::map<ExperienceId, std::vector<std::string>> labels;
  for (const auto& [label, place] : map.labels()) labels[place.experience].push_back(label);
  const std::set<std::string> methods = methods_in(map);
  std::vector<msg::ExperienceRow> rows;
  for (const auto& [id, experience] : map.experiences()) {
    if (experience->places.empty()) continue;
    msg::ExperienceRow row;
    row.id = id;
    row.name = experience->name;
    row.robot = experience->robot;
    row.method = experience->method;
    row.sealed = experience->sealed;
    row.places = static_cast<std::uint32_t>(experience->places.size());
    for (const Edge& hop : experience->chain) row.metres += distance_m(hop.a_from_b);
    if (const auto at = begun.find(id); at != begun.end()) row.begun = at->second;
    if (const auto named = labels.find(id); named != labels.end()) row.labels = std::move(named->second);
    for (const std::string& label : row.labels) {
      if (!way_on(map, map.labels().at(label), methods).leads_on) row.leads_nowhere.push_back(label);
    }
    tell_joined(*experience, row);
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace weft::server
