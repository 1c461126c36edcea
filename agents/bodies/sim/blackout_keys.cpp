#include "agents/bodies/sim/blackout_keys.hpp"

#include <algorithm>

namespace weft::agents::sim {
namespace {

Blackout blackout_in(const config::Table& table) {
  constexpr double longest_s = 1e6;
  constexpr double farthest_m = 1000.0;
  constexpr double smallest_m = 0.05;
  const std::vector<std::string> kinds = {"dark", "covered", "left-covered", "frozen"};  // in the enum's order
  Blackout blackout;
  const std::string kind = table.choice("kind", config::required, kinds);
  for (std::size_t i = 0; i < kinds.size(); ++i)
    if (kinds[i] == kind) blackout.kind = static_cast<Blackout::Kind>(i);
  if (!table.has("from_s") && !table.has("to_s") && !table.has("near"))
    table.refuse("from_s", "is missing, as are to_s and near: it would never end; give one of them");
  blackout.from_s = table.number("from_s", 0.0, 0.0, longest_s);
  if (table.has("to_s")) blackout.to_s = table.number("to_s", config::required, 0.0, longest_s);
  if (blackout.to_s <= blackout.from_s) table.refuse("to_s", "must be greater than from_s");
  if (table.has("near")) {
    const std::vector<double> near = table.numbers("near", config::required, 3, 3, -farthest_m, farthest_m);
    if (near.size() == 3) {
      blackout.near = {near[0], near[1], near[2]};
      if (near[2] < smallest_m) table.refuse("near", "must end with a radius of at least 0.05 m: [x, y, radius]");
    }
  }
  return blackout;
}

}  // namespace

void add_blackouts_in(const config::Table& root, Site& site) {
  const bool has_pair =
      std::any_of(site.robots.begin(), site.robots.end(), [](const RobotStart& robot) { return robot.has_stereo; });
  for (const config::Table& table : root.tables("blackout", 0, 1000)) {
    site.blackouts.push_back(blackout_in(table));
    if (site.blackouts.back().kind == Blackout::Kind::left_covered && !has_pair)
      table.refuse("kind", "left-covered is of a pair, and no [[robot]] looks \"stereo\"");
  }
}

}  // namespace weft::agents::sim
