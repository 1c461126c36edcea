#include <chrono>

#include "clients/cli/commands.hpp"
#include "clients/cli/progress.hpp"
#include "storage/sqlite/restore.hpp"

namespace weft::cli {
namespace {

void show(const storage::Restored& restored, const Invocation& invocation, const Output& output) {
  if (invocation.json) {
    const nlohmann::json document = {{"revision", restored.revision.value},
                                     {"epoch", restored.epoch.value},
                                     {"kept_aside", restored.kept_aside.string()},
                                     {"findings", restored.findings}};
    output.out << printed(document) << '\n';
    return;
  }
  output.out << invocation.store << " has the map of " << invocation.file << ", revision " << restored.revision.value;
  if (!restored.kept_aside.empty()) output.out << "; what was there is " << restored.kept_aside.string();
  output.out << '\n';
  for (const std::string& finding : restored.findings) output.err << "damaged: " << finding << '\n';
}

}  // namespace

Exit run_restore(const Invocation& invocation, const Output& output) {
  ProgressLine line(output.err, [] { return SteadyTime(std::chrono::steady_clock::now().time_since_epoch()); });
  storage::RestoreOptions options;
  options.accept_damage = invocation.accept_damage;
  options.progress = [&](const storage::RestoreProgress& now) {
    msg::OperatorReply reply;
    reply.done = now.done;
    reply.total = now.total;
    reply.unit = now.unit + " (" + now.stage + ")";
    line.show(reply);
  };
  const Result<storage::Restored> restored = storage::restore(invocation.file, invocation.store, options);
  if (!restored) return report_offline(restored.error(), invocation.json, output);
  show(*restored, invocation, output);
  return Exit::done;
}

}  // namespace weft::cli
