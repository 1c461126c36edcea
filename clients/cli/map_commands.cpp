#include "clients/cli/anchor.hpp"
#include "clients/cli/commands.hpp"
#include "clients/cli/export.hpp"
#include "clients/cli/files.hpp"
#include "clients/cli/map_draw.hpp"
#include "clients/cli/registered.hpp"
#include "clients/cli/run_names.hpp"
#include "clients/cli/table.hpp"

namespace weft::cli {
namespace {
using Command = Invocation::Command;

Exit info(Session& session, const Invocation& invocation, const Output& output) {
  msg::Query query;
  query.kind = msg::Query::Kind::info;
  const Result<msg::QueryReply> reply = session.query(query, patience(invocation));
  if (!reply) return report(reply.error(), invocation.json, output);
  const msg::MapInfo& info = reply->info;
  if (invocation.json) {
    output.out << printed(to_json(info)) << '\n';
    return Exit::done;
  }
  Table table;
  table.add({"revision", std::to_string(info.revision.value)});
  table.add({"experiences", std::to_string(info.experiences)});
  table.add({"places", std::to_string(info.places)});
  table.add({"stitches", std::to_string(info.stitches)});
  table.add({"contents", std::to_string(info.contents) + ", " +
                             fixed(static_cast<double>(info.content_bytes) / bytes_a_mib, 1) + " MiB"});
  table.add({"batches", std::to_string(info.batches_acknowledged) + " acknowledged, " +
                            std::to_string(info.batches_refused) + " refused"});
  table.add({"disk free", fixed(static_cast<double>(info.disk_free_bytes) / bytes_a_mib / 1024.0, 1) + " GiB"});
  table.add({"server", info.software + ", " + info.vendor + ", " + info.engine + ", epoch " +
                           std::to_string(info.epoch.value)});
  if (!info.stopped.empty()) table.add({"store", "TAKES NOTHING: " + info.stopped});
  for (const auto& [what, times] : info.counters) table.add({"counted", std::to_string(times) + " x " + what});
  table.print(output.out);
  return Exit::done;
}

bool is_drawn(const Invocation& invocation) {
  return invocation.command == Command::map_draw;
}

/// Moves the network into the frame of a registered floor plan, if one is wanted.
Result<std::optional<Laid>> lay_on_plan(Session& session, const Window& network, const Invocation& invocation) {
  if (!wants_plan(invocation)) return std::nullopt;
  const Result<NetworkPage> page = last_page_at(session, invocation, network.revision);
  if (!page) return fail(page.error());
  const Result<std::optional<Registration>> wanted = wanted_registration(page->registrations, invocation);
  if (!wanted) return fail(wanted.error());
  if (!wanted->has_value()) return std::nullopt;
  Result<Registered> on_plan = registered(network, **wanted);
  if (!on_plan) return fail(on_plan.error());
  return Laid{std::move(on_plan->network), std::move(on_plan->layout), std::move(on_plan->caption)};
}

Result<Laid> lay(Session& session, Window network, const Invocation& invocation) {
  const std::vector<Anchor>& anchors = invocation.anchors;
  const bool wants_poses = is_drawn(invocation) || has_poses(invocation.file);
  if (!wants_poses) return Laid{std::move(network), {}, {}};
  Result<std::optional<Laid>> on_plan = lay_on_plan(session, network, invocation);
  if (!on_plan) return fail(on_plan.error());
  if (on_plan->has_value()) return **std::move(on_plan);
  Layout layout = lay_out(network);
  if (anchors.empty()) return Laid{std::move(network), std::move(layout), {}};
  Result<Anchored> held = anchored(network, layout, anchors);
  if (!held) return fail(held.error());
  std::string caption = to_text(*held, anchors.size());
  return Laid{std::move(held->network), std::move(held->layout), std::move(caption)};
}

/// Checks that the parts of the command line go together. invalid: what does not.
Result<void> check(const Invocation& invocation) {
  const bool draws = is_drawn(invocation);
  if (draws && !invocation.anchors.empty() && invocation.floor_plan.empty()) {
    return fail(ErrorCode::invalid, "--anchor goes with --floor-plan: it says where the network lies on that");
  }
  if (!draws && !invocation.plan.empty() && (!invocation.anchors.empty() || !has_poses(invocation.file))) {
    return fail(ErrorCode::invalid,
                invocation.file + ": --plan goes with files that have poses, and without --anchor");
  }
  if (!draws && !invocation.anchors.empty() && !has_poses(invocation.file)) {
    return fail(ErrorCode::invalid, invocation.file + ": JSON has no poses, --anchor means nothing there");
  }
  if (!invocation.experience.empty() && ending_of(invocation.file) != ".tum") {
    return fail(ErrorCode::invalid, invocation.file + ": --experience goes with a name that ends in .tum");
  }
  return {};
}

Result<void> write(const Laid& laid, const Names& names, const RunNames& runs, const Invocation& invocation) {
  const Result<std::string> text =
      export_text(laid.network, laid.layout, names, runs, invocation.file, invocation.experience);
  if (!text) return fail(text.error());
  return write_file(*text, invocation.file);
}

}  // namespace

Exit run_map(Session& session, const Invocation& invocation, const Output& output) {
  if (invocation.command == Command::map_info) return info(session, invocation, output);
  if (const Result<void> checked = check(invocation); !checked)
    return report(checked.error(), invocation.json, output);
  const Result<msg::QueryReply> robots = query_robots(session, patience(invocation));
  if (!robots) return report(robots.error(), invocation.json, output);
  Result<Window> network = network_at(session, invocation, {invocation.at, {}}, output);
  if (!network) return report(network.error(), invocation.json, output);
  Result<Laid> laid = lay(session, *std::move(network), invocation);
  if (!laid) return report(laid.error(), invocation.json, output);
  if (invocation.draws_mosaic) return run_map_mosaic(session, *laid, invocation, output);
  if (invocation.draws_clouds || (!is_drawn(invocation) && is_of_clouds(invocation.file)))
    return run_map_clouds(session, *laid, invocation, output);
  if (invocation.command == Command::map_draw)
    return run_map_draw(session, *std::move(laid), robots->robots, invocation, output);
  const Result<RunNames> runs = query_run_names(session, patience(invocation));
  if (!runs) return report(runs.error(), invocation.json, output);
  if (const Result<void> written = write(*laid, names_of(robots->robots), *runs, invocation); !written)
    return report(written.error(), invocation.json, output);
  say_written(laid->network, laid->caption, nlohmann::json::object(), invocation, output);
  return Exit::done;
}

}  // namespace weft::cli
