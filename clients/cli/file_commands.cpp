#include <nlohmann/json.hpp>

#include "clients/cli/commands.hpp"
#include "clients/cli/files.hpp"
#include "storage/formats/cloud.hpp"
#include "storage/formats/floor_plan.hpp"
#include "storage/formats/g2o.hpp"
#include "storage/formats/route_graph.hpp"
#include "storage/formats/trajectory.hpp"

namespace weft::cli {
namespace {

using formats::Read;

/// Holds what was read from a file of one of the open formats.
using Content = std::variant<formats::PoseGraph, formats::Trajectory, formats::Cloud, formats::RouteGraph,
                             formats::GreyImage, formats::MapServerFile>;

template <class Value>
Result<Read<Content>> widened(Result<Read<Value>> read) {
  if (!read) return fail(read.error());
  return Read<Content>{std::move(read->value), std::move(read->not_understood)};
}

Result<Read<Content>> read_any(const std::string& file) {
  const Result<Bytes> bytes = read_file(file);
  if (!bytes) return fail(bytes.error());
  const std::string_view text(reinterpret_cast<const char*>(bytes->data()), bytes->size());
  const std::string ending = ending_of(file);
  if (ending == ".g2o") return widened(formats::read_g2o(text, file));
  if (ending == ".tum" || ending == ".txt") return widened(formats::read_tum(text, file));
  if (ending == ".csv") return widened(formats::read_euroc_csv(text, file));
  if (ending == ".pcd") return widened(formats::read_pcd(*bytes, file));
  if (ending == ".ply") return widened(formats::read_ply(*bytes, file));
  if (ending == ".geojson") return widened(formats::read_route_graph(text, file));
  if (ending == ".pgm" || ending == ".png") return widened(formats::read_grey_image(*bytes, file));
  if (ending == ".yaml" || ending == ".yml") return widened(formats::read_map_server(text, file));
  return fail(ErrorCode::invalid,
              file + ": names that end in .g2o .tum .txt .csv .pcd .ply .geojson .pgm .png .yaml are read");
}

using Facts = nlohmann::ordered_json;

Facts facts_of(const formats::PoseGraph& graph) {
  return {{"kind", "pose graph"},
          {"vertices", graph.vertices.size()},
          {"edges", graph.edges.size()},
          {"fixed", graph.fixed.size()}};
}
Facts facts_of(const formats::Trajectory& trajectory) {
  const auto& samples = trajectory.samples;
  return {{"kind", "trajectory"},
          {"poses", samples.size()},
          {"seconds", samples.empty() ? 0.0 : samples.back().time_s - samples.front().time_s}};
}
Facts facts_of(const formats::Cloud& cloud) {
  return {{"kind", "cloud"},
          {"points", cloud.points.size()},
          {"width", cloud.width},
          {"height", cloud.height},
          {"intensities", !cloud.intensities.empty()},
          {"colours", !cloud.colours.empty()},
          {"normals", !cloud.normals.empty()}};
}
Facts facts_of(const formats::RouteGraph& graph) {
  return {{"kind", "route graph"}, {"nodes", graph.nodes.size()}, {"edges", graph.edges.size()}};
}
Facts facts_of(const formats::GreyImage& image) {
  return {{"kind", "image"}, {"width", image.width}, {"height", image.height}, {"white", image.white}};
}
Facts facts_of(const formats::MapServerFile& file) {
  return {{"kind", "floor plan"},
          {"image", file.image},
          {"resolution_m", file.resolution_m},
          {"origin", {file.origin.x, file.origin.y, file.origin.heading}}};
}

void say_not_understood(const std::vector<formats::NotUnderstood>& parts, const std::string& file,
                        const Output& output) {
  for (const formats::NotUnderstood& part : parts) {
    output.err << "weft: not understood: " << formats::to_string(part, file) << '\n';
  }
}

Exit info(const Invocation& invocation, const Output& output) {
  Facts all = Facts::array();
  for (const std::string& file : invocation.files) {
    const Result<Read<Content>> read = read_any(file);
    if (!read) return report_offline(read.error(), invocation.json, output);
    Facts facts = std::visit([](const auto& content) { return facts_of(content); }, read->value);
    if (!invocation.json) {
      output.out << file << ":";
      for (const auto& [name, value] : facts.items()) {
        output.out << (name == "kind" ? " " : ", " + name + " ")
                   << (value.is_string() ? value.get<std::string>() : printed(value, -1));
      }
      output.out << '\n';
    }
    say_not_understood(read->not_understood, file, output);
    facts["file"] = file;
    facts["not_understood"] = Facts::array();
    for (const auto& part : read->not_understood) {
      facts["not_understood"].push_back({{"what", part.what}, {"line", part.line}, {"times", part.count}});
    }
    all.push_back(std::move(facts));
  }
  if (invocation.json) output.out << printed(Facts{{"files", all}}) << '\n';
  return Exit::done;
}

/// Joins all contents that were read into one; several only of pose graphs.
Result<Content> joined(std::vector<Content> contents) {
  if (contents.size() == 1) return std::move(contents.front());
  std::vector<formats::PoseGraph> graphs;
  for (Content& content : contents) {
    auto* const graph = std::get_if<formats::PoseGraph>(&content);
    if (graph == nullptr) return fail(ErrorCode::invalid, "several files become one only when all are pose graphs");
    graphs.push_back(std::move(*graph));
  }
  Result<formats::PoseGraph> all = formats::join(graphs);
  if (!all) return fail(all.error());
  return Content{*std::move(all)};
}

/// Thins the content, which has to be a cloud when that is asked for.
Result<Content> with_thinning(Content content, const Thinning& thinning) {
  if (!thinning.is_any()) return content;
  const auto* const cloud = std::get_if<formats::Cloud>(&content);
  if (cloud == nullptr) return fail(ErrorCode::invalid, "--voxel and --alone thin clouds, this is none");
  Result<formats::Cloud> thin = thinned(*cloud, thinning);
  if (!thin) return fail(thin.error());
  return Content{*std::move(thin)};
}

Result<Bytes> bytes_for(const Content& content, const std::string& out, bool as_text) {
  const std::string ending = ending_of(out);
  const auto coding = as_text ? formats::CloudCoding::text : formats::CloudCoding::binary;
  const auto bytes_of = [](const std::string& text) { return Bytes(text.begin(), text.end()); };
  const auto* const cloud = std::get_if<formats::Cloud>(&content);
  const auto* const trajectory = std::get_if<formats::Trajectory>(&content);
  const auto* const graph = std::get_if<formats::PoseGraph>(&content);
  if (cloud != nullptr && ending == ".pcd") return formats::pcd_bytes(*cloud, coding);
  if (cloud != nullptr && ending == ".ply") return formats::ply_bytes(*cloud, coding);
  if (trajectory != nullptr && ending == ".tum") return bytes_of(formats::tum_text(*trajectory));
  if (graph != nullptr && ending == ".g2o") return bytes_of(formats::g2o_text(*graph));
  return fail(ErrorCode::invalid,
              out + ": clouds are written as .pcd and .ply, trajectories as .tum, pose graphs as .g2o");
}

Exit convert(const Invocation& invocation, const Output& output) {
  std::vector<Content> contents;
  for (const std::string& file : invocation.files) {
    Result<Read<Content>> read = read_any(file);
    if (!read) return report_offline(read.error(), invocation.json, output);
    say_not_understood(read->not_understood, file, output);
    contents.push_back(std::move(read->value));
  }
  Result<Content> content = joined(std::move(contents));
  if (content) content = with_thinning(*std::move(content), invocation.thinning);
  if (!content) return report_offline(content.error(), invocation.json, output);
  const Result<Bytes> bytes = bytes_for(*content, invocation.file, invocation.as_text);
  if (!bytes) return report_offline(bytes.error(), invocation.json, output);
  if (const Result<void> written = write_file(*bytes, invocation.file); !written) {
    return report_offline(written.error(), invocation.json, output);
  }
  Facts facts = std::visit([](const auto& held) { return facts_of(held); }, *content);
  facts["file"] = invocation.file;
  facts["bytes"] = bytes->size();
  if (invocation.json) {
    output.out << printed(facts) << '\n';
  } else {
    output.out << invocation.file << ": " << facts["kind"].get<std::string>() << ", " << bytes->size() << " bytes\n";
  }
  return Exit::done;
}

}  // namespace

Exit run_file(const Invocation& invocation, const Output& output) {
  return invocation.command == Invocation::Command::file_info ? info(invocation, output)
                                                              : convert(invocation, output);
}

}  // namespace weft::cli
