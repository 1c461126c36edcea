#include <fstream>

#include "clients/cli/commands.hpp"
#include "clients/cli/draw.hpp"
#include "clients/cli/table.hpp"

namespace weft::cli {
namespace {
using Command = Invocation::Command;

constexpr double kMiB = 1024.0 * 1024.0;

Exit info(Session& session, const Invocation& invocation, const Output& output) {
  msg::Query query;
  query.kind = msg::Query::Kind::info;
  const Result<msg::QueryReply> reply = session.query(query, patience(invocation));
  if (!reply) return report(reply.error(), invocation.json, output);
  const msg::MapInfo& info = reply->info;
  if (invocation.json) {
    output.out << to_json(info).dump(2) << '\n';
    return Exit::done;
  }
  Table table;
  table.add({"revision", std::to_string(info.revision.value)});
  table.add({"experiences", std::to_string(info.experiences)});
  table.add({"places", std::to_string(info.places)});
  table.add({"stitches", std::to_string(info.stitches)});
  table.add({"contents", std::to_string(info.contents) + ", " +
                             fixed(static_cast<double>(info.content_bytes) / kMiB, 1) + " MiB"});
  table.add({"batches", std::to_string(info.batches_acknowledged) + " acknowledged, " +
                            std::to_string(info.batches_refused) + " refused"});
  table.add({"disk free", fixed(static_cast<double>(info.disk_free_bytes) / kMiB / 1024.0, 1) + " GiB"});
  table.add({"server", info.software + ", " + info.vendor + ", " + info.engine + ", epoch " +
                           std::to_string(info.epoch.value)});
  for (const auto& [what, times] : info.counters) table.add({"counted", std::to_string(times) + " x " + what});
  table.print(output.out);
  return Exit::done;
}

Result<void> write(const std::string& text, const std::string& file) {
  std::ofstream out(file, std::ios::trunc);
  out << text << '\n';
  out.close();
  if (!out) return fail(ErrorCode::exhausted, file + ": cannot be written; is the folder there?");
  return {};
}

}  // namespace

Exit run_map(Session& session, const Invocation& invocation, const Output& output) {
  if (invocation.command == Command::map_info) return info(session, invocation, output);
  const Result<msg::QueryReply> robots = query_robots(session, patience(invocation));
  if (!robots) return report(robots.error(), invocation.json, output);
  const Result<Window> network = session.network(patience(invocation));
  if (!network) return report(network.error(), invocation.json, output);
  const Result<void> written = invocation.command == Command::map_draw
                                   ? draw(*network, robots->robots, invocation.file)
                                   : write(to_json(*network, names_of(robots->robots)).dump(1), invocation.file);
  if (!written) return report(written.error(), invocation.json, output);
  if (invocation.json) {
    const nlohmann::json document = {{"file", invocation.file},
                                     {"revision", network->revision.value},
                                     {"places", network->places.size()},
                                     {"edges", network->edges.size()}};
    output.out << document.dump(2) << '\n';
  } else {
    output.out << invocation.file << ": revision " << network->revision.value << ", " << network->places.size()
               << " places\n";
  }
  return Exit::done;
}

}  // namespace weft::cli
