#include <algorithm>
#include <tuple>

#include "clients/cli/commands.hpp"
#include "clients/cli/run_names.hpp"
#include "clients/cli/table.hpp"
#include "core/network/imported.hpp"
#include "core/text.hpp"

/// Holds the command `map list`, which shows what was taught and imported.
namespace weft::cli {
namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text.empty() ? "-" : text;
}

/// Returns the labels, and says of those that no robot could leave again.
std::vector<std::string> shown_labels(const msg::ExperienceRow& row) {
  std::vector<std::string> shown = row.labels;
  for (std::string& label : shown) {
    if (std::ranges::find(row.leads_nowhere, label) != row.leads_nowhere.end()) label += " (leads nowhere)";
  }
  return shown;
}

/// Returns the name of the robot that taught the run; "-" for an import, which no robot taught.
std::string taught_by(const msg::ExperienceRow& row, const Names& robots) {
  return row.method == kImportedMethod ? std::string("-") : name_of(robots, row.robot);
}

nlohmann::json document_of(const msg::ExperienceRow& row, const Names& robots) {
  nlohmann::json document = {{"id", to_string(row.id)},
                             {"name", row.name},
                             {"method", row.method},
                             {"ended", row.sealed},
                             {"places", row.places},
                             {"metres", row.metres},
                             {"labels", row.labels},
                             {"leads_nowhere", row.leads_nowhere},
                             {"joined", nlohmann::json::array()},
                             {"joined_count", row.joined_count}};
  if (row.method != kImportedMethod) document["robot"] = name_of(robots, row.robot);
  if (row.begun != WallTime{}) document["begun"] = iso_time(row.begun);
  for (const ExperienceId& id : row.joined) document["joined"].push_back(to_string(id));
  return document;
}

void print(const std::vector<msg::ExperienceRow>& rows, const Names& robots, const Output& output) {
  RunNames names;
  for (const msg::ExperienceRow& row : rows) {
    if (!row.name.empty()) names[row.id] = row.name;
  }
  Table table;
  table.add({"NAME", "ID", "BY", "BEGUN", "METHOD", "PLACES", "METRES", "LABELS", "JOINED TO"});
  for (const msg::ExperienceRow& row : rows) {
    std::vector<std::string> others;
    for (const ExperienceId& id : row.joined) others.push_back(shown_run(id, names));
    if (row.joined_count > row.joined.size()) {
      others.push_back(std::to_string(row.joined_count - row.joined.size()) + " more");
    }
    table.add({row.name.empty() ? "-" : row.name, to_string(row.id), taught_by(row, robots),
               row.begun == WallTime{} ? "-" : iso_time(row.begun), row.method,
               std::to_string(row.places) + (row.sealed ? "" : ", goes on"), fixed(row.metres, 1),
               joined(shown_labels(row)), joined(others)});
  }
  table.print(output.out);
}

nlohmann::json document_of(const msg::AwaitedLabelRow& row, const Names& robots) {
  return {
      {"label", row.label}, {"place", to_string(row.place)}, {"robot", name_of(robots, row.robot)}, {"who", row.who}};
}

void print(const std::vector<msg::AwaitedLabelRow>& rows, const Names& robots, const Output& output) {
  for (const msg::AwaitedLabelRow& row : rows) {
    output.out << "label " << row.label << ", given by " << row.who << ", waits for place " << to_string(row.place)
               << " which " << name_of(robots, row.robot) << " has not handed in; weft map unlabel " << row.label
               << " withdraws it\n";
  }
}

}  // namespace

Exit run_map_list(Session& session, const Invocation& invocation, const Output& output) {
  const Result<msg::QueryReply> robots = query_robots(session, patience(invocation));
  if (!robots) return report(robots.error(), invocation.json, output);
  msg::Query query;
  query.kind = msg::Query::Kind::experiences;
  Result<msg::QueryReply> reply = session.query(query, patience(invocation));
  if (!reply) return report(reply.error(), invocation.json, output);
  std::ranges::sort(reply->experiences, {},
                    [](const msg::ExperienceRow& row) { return std::tie(row.begun, row.name, row.id); });
  const Names names = names_of(robots->robots);
  if (invocation.json) {
    nlohmann::json document = {{"experiences", nlohmann::json::array()}, {"awaited_labels", nlohmann::json::array()}};
    for (const msg::ExperienceRow& row : reply->experiences) {
      document["experiences"].push_back(document_of(row, names));
    }
    for (const msg::AwaitedLabelRow& row : reply->awaited_labels) {
      document["awaited_labels"].push_back(document_of(row, names));
    }
    output.out << printed(document) << '\n';
    return Exit::done;
  }
  if (reply->experiences.empty()) {
    output.out << "nothing has been taught yet: weft teach ROBOT start\n";
  } else {
    print(reply->experiences, names, output);
  }
  print(reply->awaited_labels, names, output);
  return Exit::done;
}

}  // namespace weft::cli
