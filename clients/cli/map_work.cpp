#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "clients/cli/commands.hpp"
#include "clients/cli/progress.hpp"
#include "clients/cli/table.hpp"

/// Holds the commands that edit the map, each edit one revision, and those for upkeep of the store.
namespace weft::cli {
namespace {

using Command = Invocation::Command;
using Kind = msg::OperatorRequest::Kind;

Kind kind_of(const Invocation& invocation) {
  switch (invocation.command) {
    case Command::map_rollback:
      return Kind::rollback;
    case Command::map_undo:
      return Kind::undo;
    case Command::map_quarantine:
      return Kind::quarantine;
    case Command::map_replace:
      return Kind::replace;
    case Command::map_compact:
      return Kind::compact;
    case Command::map_snapshot:
      return invocation.verifies ? Kind::snapshot_verified : Kind::snapshot;
    case Command::map_apart:
      return Kind::apart;
    case Command::map_check:
      return Kind::check;
    case Command::map_stats:
      return Kind::stats;
    default:
      return Kind::prune;
  }
}

/// Reads "E:I..J"; none when the text is not of that form.
std::optional<Stretch> parse_stretch(const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) return std::nullopt;
  const std::optional<PlaceId> first = parse_place_id(text.substr(0, dots));
  std::uint32_t last = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + dots + 2, end, last);
  if (!first.has_value() || error != std::errc{} || stop != end) return std::nullopt;
  return Stretch{first->experience, first->index, last};
}

std::optional<EdgeId> parse_stitch(const std::string& text) {
  const std::size_t dash = text.find('-');
  if (dash == std::string::npos) return std::nullopt;
  const std::optional<PlaceId> a = parse_place_id(text.substr(0, dash));
  const std::optional<PlaceId> b = parse_place_id(text.substr(dash + 1));
  if (!a.has_value() || !b.has_value()) return std::nullopt;
  return EdgeId{*a, *b};
}

/// Puts what the work is about into the request: a stitch, places, or else the name or id of an experience. invalid:
/// it looks like a stitch or places, and is none.
Result<void> put_what(const std::string& what, msg::OperatorRequest& request) {
  if (const auto stitch = parse_stitch(what); stitch.has_value()) {
    request.work.what.stitches = {*stitch};
  } else if (const auto stretch = parse_stretch(what); stretch.has_value()) {
    if (stretch->first > stretch->last) return fail(ErrorCode::invalid, what + ": the first comes after the last");
    request.work.what.places = {*stretch};
  } else if (const auto place = parse_place_id(what); place.has_value()) {
    request.work.what.places = {{place->experience, place->index, place->index}};
  } else if (what.find(':') != std::string::npos || what.size() > 64) {
    return fail(ErrorCode::invalid, "'" + what +
                                        "' is no stitch E:I-F:J, no place E:I and no places E:I..J with E and "
                                        "F of 16 hex digits, as `weft map export` and `weft map diff` write them");
  } else {
    request.label = what;
  }
  return {};
}

Result<void> put_apart(const std::vector<std::string>& named, msg::OperatorRequest& request) {
  for (const std::string& text : named) {
    std::optional<Stretch> stretch = parse_stretch(text);
    if (const auto place = parse_place_id(text); place.has_value()) {
      stretch = Stretch{place->experience, place->index, place->index};
    }
    if (!stretch.has_value()) {
      return fail(ErrorCode::invalid,
                  "'" + text +
                      "' is no stretch E:I..J, with E of 16 hex digits and I and J indices of its "
                      "places; `weft map export` and `weft map draw` show them");
    }
    if (stretch->first > stretch->last) return fail(ErrorCode::invalid, text + ": the first comes after the last");
    request.work.what.places.push_back(*stretch);
  }
  return {};
}

/// Shows a row for each kind; the server names its numbers "kind: what".
void show_space(const msg::OperatorReply& reply, const Output& output) {
  Table table;
  table.add({"WHAT", "COUNT", "BYTES ON DISK", "AS HANDED IN"});
  std::vector<std::string> row;
  for (const auto& [name, count] : reply.counts) {
    const std::string kind = name.substr(0, name.find(':'));
    if (!row.empty() && row.front() != kind) table.add(std::exchange(row, {}));
    if (row.empty()) row.push_back(kind);
    row.push_back(std::to_string(count));
  }
  if (!row.empty()) table.add(std::move(row));
  table.print(output.out);
}

}  // namespace

Result<msg::OperatorRequest> map_work(const Invocation& invocation) {
  msg::OperatorRequest request;
  request.kind = kind_of(invocation);
  request.work.revision = invocation.to;
  request.work.only_say = invocation.only_say;
  request.work.within_m = invocation.within_m;
  request.work.within_rad = invocation.within_deg * std::numbers::pi / 180.0;
  request.work.file = invocation.file;
  if (invocation.command == Command::map_apart) {
    if (const Result<void> good = put_apart(invocation.apart, request); !good) return fail(good.error());
    return request;
  }
  if (invocation.what.empty()) return request;
  if (request.kind == Kind::replace) {
    request.label = invocation.what;
    return request;
  }
  if (const Result<void> good = put_what(invocation.what, request); !good) return fail(good.error());
  return request;
}

Result<NetworkPage> last_page_at(Session& session, const Invocation& invocation, Revision revision) {
  msg::Query query;
  query.kind = msg::Query::Kind::network;
  query.at = revision;
  query.after = kBehindAll;  // they come with the last page
  Result<msg::QueryReply> reply = session.query(query, patience(invocation));
  if (!reply) return fail(reply.error());
  return std::move(reply->network);
}

Result<std::vector<Apart>> aparts_at(Session& session, const Invocation& invocation, Revision revision) {
  Result<NetworkPage> page = last_page_at(session, invocation, revision);
  if (!page) return fail(page.error());
  return std::move(page->aparts);
}

Exit run_apart(Session& session, const Invocation& invocation, const Output& output) {
  if (!invocation.lists) return run_map_work(session, invocation, output);
  const auto aparts = aparts_at(session, invocation, {});
  if (!aparts) return report(aparts.error(), invocation.json, output);
  if (invocation.json) {
    nlohmann::json document = {{"apart", nlohmann::json::array()}};
    for (const Apart& apart : *aparts) document["apart"].push_back({to_string(apart.one), to_string(apart.other)});
    output.out << printed(document) << '\n';
    return Exit::done;
  }
  for (const Apart& apart : *aparts) output.out << to_string(apart) << '\n';
  if (aparts->empty()) output.out << "no stretches are apart\n";
  return Exit::done;
}

Exit run_map_work(Session& session, const Invocation& invocation, const Output& output) {
  Result<msg::OperatorRequest> request = map_work(invocation);
  if (!request) return report(request.error(), invocation.json, output);
  ProgressLine line(output.err, session.world().now);
  const Result<msg::OperatorReply> reply =
      session.ask(*std::move(request), patience(invocation), [&](const msg::OperatorReply& now) { line.show(now); });
  if (!reply) return report(reply.error(), invocation.json, output);
  if (!invocation.json) line.rest(*reply);
  const Exit exit = show(*reply, invocation, output);
  if (!invocation.json && invocation.command == Command::map_stats) show_space(*reply, output);
  return exit;
}

}  // namespace weft::cli
