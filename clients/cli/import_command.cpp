#include <algorithm>

#include "clients/cli/commands.hpp"
#include "clients/cli/files.hpp"
#include "clients/cli/uploader.hpp"
#include "storage/formats/g2o.hpp"
#include "storage/formats/import.hpp"

namespace weft::cli {
namespace {

Result<formats::PoseGraph> read_graphs(const std::vector<std::string>& files, const Output& output) {
  std::vector<formats::PoseGraph> graphs;
  for (const std::string& file : files) {
    if (ending_of(file) != ".g2o") {
      return fail(ErrorCode::invalid, file + ": pose graphs (*.g2o) are imported; other files have no relations");
    }
    const Result<std::string> text = read_text(file);
    if (!text) return fail(text.error());
    auto graph = formats::read_g2o(*text, file);
    if (!graph) return fail(graph.error());
    for (const formats::NotUnderstood& part : graph->not_understood) {
      output.err << "weft: not understood: " << formats::to_string(part, file) << '\n';
    }
    graphs.push_back(std::move(graph->value));
  }
  return formats::join(graphs);
}

/// Puts each label as NAME.LABEL: those that the network has already stay where they are.
Result<void> put_labels(Session& session, const formats::Import& import, const Invocation& invocation) {
  for (const auto& [label, place] : import.labels) {
    msg::OperatorRequest request;
    request.kind = msg::OperatorRequest::Kind::label;
    request.label = invocation.name + "." + label;
    request.place = place;
    const Result<msg::OperatorReply> reply = session.ask(request, patience(invocation));
    if (!reply) return fail(reply.error());
    if (reply->outcome != msg::Outcome::done) return fail(ErrorCode::refused, reply->message);
  }
  return {};
}

std::size_t count(const formats::Import& import, bool stitches) {
  std::size_t all = 0;
  for (const Batch& batch : import.batches) {
    all += static_cast<std::size_t>(std::count_if(batch.edges.begin(), batch.edges.end(), [&](const Edge& edge) {
      return (edge.origin == Origin::stitch) == stitches;
    }));
  }
  return all;
}

void show(const formats::Import& import, const Invocation& invocation, const Output& output) {
  const auto experiences = std::count_if(import.batches.begin(), import.batches.end(),
                                         [](const Batch& batch) { return batch.sequence == 1; });
  if (invocation.json) {
    const nlohmann::json document = {
        {"name", invocation.name},         {"experiences", experiences},     {"places", import.place_of_key.size()},
        {"stitches", count(import, true)}, {"labels", import.labels.size()}, {"left_out", import.left_out}};
    output.out << printed(document) << '\n';
    return;
  }
  output.out << invocation.name << ": " << import.place_of_key.size() << " places in " << experiences
             << " experiences, " << count(import, true) << " stitches, " << import.labels.size() << " labels\n";
  for (const std::string& part : import.left_out) output.out << "left out: " << part << '\n';
}

}  // namespace

PeerId identity(const Invocation& invocation, const PeerId& otherwise) {
  return invocation.command == Invocation::Command::map_import ? formats::import_robot(invocation.name) : otherwise;
}

Exit run_import(Session& session, const Invocation& invocation, const Output& output) {
  const Result<formats::PoseGraph> graph = read_graphs(invocation.files, output);
  if (!graph) return report(graph.error(), invocation.json, output);
  const Result<formats::Import> import = formats::import_of(*graph, invocation.name);
  if (!import) return report(import.error(), invocation.json, output);
  Uploader uploader(import->batches, import->contents);
  if (const Result<void> handed = session.upload(uploader, patience(invocation)); !handed) {
    return report(handed.error(), invocation.json, output);
  }
  if (const Result<void> labelled = put_labels(session, *import, invocation); !labelled) {
    return report(labelled.error(), invocation.json, output);
  }
  show(*import, invocation, output);
  return Exit::done;
}

}  // namespace weft::cli
