#include "agents/bodies/sim/changes.hpp"

#include <algorithm>

#include "agents/bodies/sim/floor/procedural.hpp"

namespace weft::agents::sim {
namespace {

bool holds(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

Error unknown(const std::string& what, const std::string& name, const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& known : names) list += (list.empty() ? "" : ", ") + known;
  return {ErrorCode::invalid, "no " + what + " \"" + name + "\"; there are " + list};
}

}  // namespace

const std::vector<std::string>& floor_kinds() {
  static const std::vector<std::string> names = {"polished-concrete", "worn-concrete", "epoxy", "asphalt"};
  return names;
}

Result<Site> on_floor(Site site, const std::string& kind) {
  std::vector<std::string> names;
  for (const Material& material : materials()) names.push_back(material.name);
  if (!holds(names, kind)) return fail(unknown("floor", kind, names));
  site.floor.material = kind;
  return site;
}

const std::vector<std::string>& light_names() {
  static const std::vector<std::string> names = {"same", "halved"};
  return names;
}

Result<Site> under_light(Site site, const std::string& name) {
  if (!holds(light_names(), name)) return fail(unknown("light", name, light_names()));
  if (name == "halved") site.change.light = 0.5;
  return site;
}

const std::vector<std::string>& wear_names() {
  static const std::vector<std::string> names = {"same"};
  return names;
}

Result<Site> with_wear(Site site, const std::string& name) {
  if (!holds(wear_names(), name)) return fail(unknown("wear", name, wear_names()));
  return site;
}

}  // namespace weft::agents::sim
