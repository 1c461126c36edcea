#include <algorithm>

#include "clients/cli/commands.hpp"
#include "clients/cli/difference.hpp"
#include "clients/cli/draw_difference.hpp"
#include "clients/cli/progress.hpp"
#include "clients/cli/table.hpp"
#include "core/text.hpp"

/// Holds the commands on the map's past: what each revision did, and what two of them differ in.
namespace weft::cli {
namespace {

using Command = Invocation::Command;

constexpr std::uint64_t kMostDrawnWhole = 20'000;  ///< places

/// Returns who asked, by name where it is one of the fleet's robots.
std::string asker(const std::string& who, const Names& names) {
  for (const auto& [id, name] : names) {
    if (to_string(id) == who) return name;
  }
  return who;
}

std::string when(WallTime at) {
  return at == WallTime{} ? "-" : iso_time(at);
}

nlohmann::json document_of(const msg::RevisionNote& note, const Names& names) {
  nlohmann::json document = {{"revision", note.revision.value},
                             {"base", note.base.value},
                             {"kind", note.kind},
                             {"who", asker(note.who, names)},
                             {"cause", note.cause}};
  if (note.at != WallTime{}) document["at"] = iso_time(note.at);
  return document;
}

Exit log(Session& session, const Invocation& invocation, const Output& output) {
  const Result<msg::QueryReply> robots = query_robots(session, patience(invocation));
  if (!robots) return report(robots.error(), invocation.json, output);
  const Names names = names_of(robots->robots);
  msg::Query query;
  query.kind = msg::Query::Kind::log;
  query.newest = invocation.to;
  query.most = invocation.most;
  const Result<msg::QueryReply> reply = session.query(query, patience(invocation));
  if (!reply) return report(reply.error(), invocation.json, output);
  if (invocation.json) {
    nlohmann::json document = {{"revisions", nlohmann::json::array()}};
    for (const msg::RevisionNote& note : reply->log) document["revisions"].push_back(document_of(note, names));
    output.out << printed(document) << '\n';
    return Exit::done;
  }
  if (reply->log.empty()) {
    output.out << "nothing has changed the map yet\n";
    return Exit::done;
  }
  Table table;
  table.add({"REVISION", "WHEN", "WHO", "WHAT", "CAUSE"});
  for (const msg::RevisionNote& note : reply->log) {
    table.add({std::to_string(note.revision.value), when(note.at), asker(note.who, names), note.kind, note.cause});
  }
  table.print(output.out);
  return Exit::done;
}

template <class Id>
nlohmann::json list(const std::vector<Id>& ids) {
  nlohmann::json all = nlohmann::json::array();
  for (const Id& id : ids) {
    if constexpr (std::is_same_v<Id, EdgeId>) {
      all.push_back(to_string(id.a) + " - " + to_string(id.b));
    } else if constexpr (std::is_same_v<Id, PlaceId> || std::is_same_v<Id, Apart>) {
      all.push_back(to_string(id));
    } else {
      all.push_back(id);
    }
  }
  return all;
}

std::string names(const std::vector<std::string>& labels) {
  std::string text;
  for (const std::string& label : labels) text += (text.empty() ? "" : ", ") + label;
  return text.empty() ? "-" : text;
}

void print(const NetworkDifference& found, const Output& output) {
  const auto count = [](std::size_t number) { return std::to_string(number); };
  Table table;
  table.add({"", "CAME", "WENT"});
  table.add({"places", count(found.places_added.size()), count(found.places_removed.size())});
  table.add({"stitches", count(found.stitches_added.size()), count(found.stitches_removed.size())});
  table.add({"aparts", count(found.aparts_added.size()), count(found.aparts_removed.size())});
  table.add({"rules", names(found.rules_added), names(found.rules_removed)});
  table.add({"plans", names(found.plans_added), names(found.plans_removed)});
  table.add({"labels", names(found.labels_added), names(found.labels_removed)});
  table.print(output.out);
  if (!found.places_anew.empty()) output.out << "places known anew: " << found.places_anew.size() << '\n';
  if (!found.labels_moved.empty()) output.out << "labels moved: " << names(found.labels_moved) << '\n';
  if (!found.rules_changed.empty()) output.out << "rules changed: " << names(found.rules_changed) << '\n';
  if (!found.plans_changed.empty()) output.out << "plans registered anew: " << names(found.plans_changed) << '\n';
  for (const Apart& apart : found.aparts_added) output.out << "apart: " << to_string(apart) << '\n';
  for (const Apart& apart : found.aparts_removed) output.out << "apart no longer: " << to_string(apart) << '\n';
  if (found.empty()) output.out << "the same map\n";
}

/// Returns whether a picture is wanted, and has room for what two revisions share (judged by the map as it is).
Result<bool> is_drawn_whole(Session& session, const Invocation& invocation) {
  if (invocation.file.empty()) return false;
  msg::Query query;
  query.kind = msg::Query::Kind::info;
  const Result<msg::QueryReply> now = session.query(query, patience(invocation));
  if (!now) return fail(now.error());
  return now->info.places <= kMostDrawnWhole;
}

Exit diff(Session& session, const Invocation& invocation, const Output& output) {
  const Result<bool> is_whole = is_drawn_whole(session, invocation);
  if (!is_whole) return report(is_whole.error(), invocation.json, output);
  const auto apart_from = [&](Revision other) { return *is_whole ? Revision{} : other; };
  const Result<Window> to = network_at(session, invocation, {invocation.to, apart_from(invocation.from)}, output);
  if (!to) return report(to.error(), invocation.json, output);
  const Result<Window> from = network_at(session, invocation, {invocation.from, apart_from(to->revision)}, output);
  if (!from) return report(from.error(), invocation.json, output);
  NetworkDifference found = compare(*from, *to);
  const Result<NetworkPage> page_to = last_page_at(session, invocation, to->revision);
  if (!page_to) return report(page_to.error(), invocation.json, output);
  const Result<NetworkPage> page_from = last_page_at(session, invocation, from->revision);
  if (!page_from) return report(page_from.error(), invocation.json, output);
  compare_aparts(page_from->aparts, page_to->aparts, found);
  compare_rules(page_from->rules, page_to->rules, found);
  compare_registrations(page_from->registrations, page_to->registrations, found);
  if (!invocation.file.empty()) {
    const std::string only = *is_whole ? "" : "; only runs that differ";
    if (const Result<void> drawn = draw_difference(*from, *to, only, invocation.file); !drawn)
      return report(drawn.error(), invocation.json, output);
  }
  if (invocation.json) {
    const nlohmann::json document = {
        {"from", found.from.value},
        {"to", found.to.value},
        {"places",
         {{"came", list(found.places_added)},
          {"went", list(found.places_removed)},
          {"known_anew", list(found.places_anew)}}},
        {"stitches", {{"came", list(found.stitches_added)}, {"went", list(found.stitches_removed)}}},
        {"labels",
         {{"came", list(found.labels_added)},
          {"went", list(found.labels_removed)},
          {"moved", list(found.labels_moved)}}},
        {"aparts", {{"came", list(found.aparts_added)}, {"went", list(found.aparts_removed)}}},
        {"rules",
         {{"came", list(found.rules_added)},
          {"went", list(found.rules_removed)},
          {"changed", list(found.rules_changed)}}},
        {"plans",
         {{"came", list(found.plans_added)},
          {"went", list(found.plans_removed)},
          {"changed", list(found.plans_changed)}}}};
    output.out << printed(document) << '\n';
  } else {
    print(found, output);
  }
  return Exit::done;
}

}  // namespace

Result<Window> network_at(Session& session, const Invocation& invocation, Session::Wanted wanted,
                          const Output& output) {
  ProgressLine line(output.err, session.world().now);
  return session.network(wanted, patience(invocation), [&](const PagedNetwork& so_far) {
    msg::OperatorReply read;
    read.done = so_far.done();
    read.total = so_far.total();
    read.unit = "places read";
    line.show(read);
  });
}

Exit run_history(Session& session, const Invocation& invocation, const Output& output) {
  return invocation.command == Command::map_log ? log(session, invocation, output)
                                                : diff(session, invocation, output);
}

}  // namespace weft::cli
