#include <algorithm>

#include "clients/cli/commands.hpp"
#include "clients/cli/table.hpp"

namespace weft::cli {

Exit run_counts(Session& session, const Invocation& invocation, const Output& output) {
  msg::OperatorRequest request;
  request.kind = msg::OperatorRequest::Kind::robot_counts;
  request.robot = invocation.robot;
  Result<msg::OperatorReply> reply = session.ask(std::move(request), patience(invocation));
  if (!reply) return report(reply.error(), invocation.json, output);
  if (reply->outcome != msg::Outcome::done || invocation.json) return show(*reply, invocation, output);
  if (reply->counts.empty()) {
    output.out << invocation.robot << " has counted nothing since its agent started\n";
    return Exit::done;
  }
  std::ranges::stable_sort(reply->counts, std::ranges::greater{}, [](const auto& count) { return count.second; });
  Table table;
  table.add({"TIMES", "WHAT"});
  for (const auto& [what, times] : reply->counts) table.add({std::to_string(times), what});
  table.print(output.out);
  return Exit::done;
}

}  // namespace weft::cli
