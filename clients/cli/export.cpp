#include "clients/cli/export.hpp"

#include <set>

#include "clients/cli/files.hpp"
#include "storage/formats/g2o.hpp"
#include "storage/formats/network_export.hpp"

namespace weft::cli {
namespace {

/// Finds the experience by its name, or else by the beginning of its id.
Result<ExperienceId> experience_in(const Window& network, const RunNames& runs, const std::string& called) {
  std::set<ExperienceId> fitting, named;
  for (const auto& [id, place] : network.places) {
    const auto run = runs.find(id.experience);
    if (run != runs.end() && run->second == called) named.insert(id.experience);
    if (to_string(id.experience).starts_with(called)) fitting.insert(id.experience);
  }
  if (!named.empty()) fitting = std::move(named);
  if (fitting.size() == 1) return *fitting.begin();
  return fail(ErrorCode::invalid, "a .tum file holds one experience, and " + std::to_string(fitting.size()) +
                                      " fit: give --experience NAME or ID as `weft map list` has them");
}

template <class Value, class Write>
Result<std::string> written(const Result<Value>& value, Write&& write) {
  if (!value) return fail(value.error());
  return write(*value);
}

}  // namespace

bool has_poses(const std::string& file) {
  static const std::set<std::string> kWithPoses = {".g2o", ".geojson", ".dot", ".graphml", ".tum"};
  return kWithPoses.contains(ending_of(file)) || is_of_clouds(file);
}

bool is_of_clouds(const std::string& file) {
  return ending_of(file) == ".pcd" || ending_of(file) == ".ply";
}

Result<std::string> export_text(const Window& network, const Layout& layout, const Names& names, const RunNames& runs,
                                const std::string& file, const std::string& experience) {
  const std::string ending = ending_of(file);
  const formats::Poses& poses = layout.drawing_from_place;
  if (ending == ".g2o") return written(formats::pose_graph_of(network, poses), formats::g2o_text);
  if (ending == ".geojson") return written(formats::route_graph_of(network, poses), formats::route_graph_text);
  if (ending == ".dot") return formats::dot_text(network, poses);
  if (ending == ".graphml") return formats::graphml_text(network, poses);
  if (ending == ".tum") {
    const Result<ExperienceId> of = experience_in(network, runs, experience);
    if (!of) return fail(of.error());
    return written(formats::trajectory_of(network, poses, *of), formats::tum_text);
  }
  return printed(to_json(network, names, runs), 1) + "\n";
}

}  // namespace weft::cli
