#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "clients/cli/findings.hpp"
#include "clients/cli/table.hpp"

namespace weft::cli {
namespace {

constexpr std::uint64_t kSpoolLow = 1ULL << 28U;  // bytes
constexpr std::uint64_t kEnoughMessages = 100;    // before a share of them says something
constexpr double kMiB = 1024.0 * 1024.0;

/// Says how one thing of a robot is: in a cell of the table, and what is wrong with it; empty: nothing.
struct Checked {
  std::string cell;
  std::string problem = {};
};

Checked clock_of(const msg::RobotRow& row) {
  const bool good = std::abs(row.clock_skew_s) <= msg::kClockOff_s;
  return {fixed(row.clock_skew_s * 1000.0, 0) + " ms", good ? "" : "its clock is off: run an NTP client there"};
}

Checked disk_of(const msg::RobotState& state) {
  if (!state.spool_refuses.empty()) return {"REFUSES", "its spool takes nothing: " + state.spool_refuses};
  std::string cell = state.spool_free_bytes
                         ? fixed(static_cast<double>(*state.spool_free_bytes) / kMiB, 0) + " MiB free"
                         : "not known";
  if (state.spool_batches > 0) cell += ", " + std::to_string(state.spool_batches) + " to hand in";
  const bool is_low = state.spool_free_bytes && *state.spool_free_bytes < kSpoolLow;
  return {std::move(cell), is_low ? "its disk is nearly full: make room, or it cannot be taught" : ""};
}

/// Returns what share of the robot's messages did not come; none: too few have come to tell.
std::optional<double> missed_of(const msg::RobotRow& row) {
  const std::uint64_t sent = row.messages_heard + row.messages_missed;
  if (sent < kEnoughMessages) return std::nullopt;
  return static_cast<double>(row.messages_missed) / static_cast<double>(sent);
}

Checked link_of(const msg::RobotRow& row) {
  if (!row.is_heard || row.silent_s > kSilent_s) {
    return {"silent for " + fixed(row.silent_s, 0) + " s",
            "it is not heard: is its agent running, and in the network?"};
  }
  std::string cell = "heard " + fixed(row.silent_s, 1) + " s ago";
  if (row.is_deaf) {
    return {cell + ", deaf for " + fixed(row.state.server_unheard_s, 0) + " s",
            "it hears nothing of the server, which hears it: look at the way from the server to it"};
  }
  const std::optional<double> missed = missed_of(row);
  if (missed) cell += ", " + fixed(100.0 * *missed, 1) + " % missed";
  return {std::move(cell),
          missed && *missed > kLossy ? "messages of it are lost: run weft doctor network there" : ""};
}

Checked version_of(const msg::RobotRow& row, const std::string& server) {
  if (row.software.empty()) return {"not known"};  // it has not said hello since the server's start
  return {row.software, row.software == server ? "" : "its version is not the server's, " + server + ": update"};
}

std::string methods_of(const msg::RobotRow& row) {
  std::string all;
  for (const std::string& method : row.description.methods) all += (all.empty() ? "" : ",") + method;
  return all.empty() ? "not known" : all;
}

nlohmann::json document_of(const msg::RobotRow& row, const std::vector<std::string>& problems) {
  const msg::RobotState& state = row.state;
  const std::optional<double> missed = missed_of(row);
  const auto known = [](const auto& value) { return value ? nlohmann::json(*value) : nlohmann::json(); };
  return {{"name", row.description.name},
          {"id", to_string(row.description.header.sender)},
          {"good", problems.empty()},
          {"problems", problems},
          {"clock_skew_s", row.clock_skew_s},
          {"disk",
           {{"free_bytes", known(state.spool_free_bytes)},
            {"refuses", state.spool_refuses.empty() ? nlohmann::json() : nlohmann::json(state.spool_refuses)},
            {"batches", state.spool_batches}}},
          {"link",
           {{"heard", row.is_heard},
            {"silent_s", row.silent_s},
            {"messages_heard", row.messages_heard},
            {"messages_missed", row.messages_missed},
            {"missed_share", known(missed)}}},
          {"software", row.software},
          {"vendor", row.vendor},
          {"methods", row.description.methods}};
}

}  // namespace

Exit run_doctor_fleet(Session& session, const Invocation& invocation, const Output& output) {
  msg::Query query;
  query.kind = msg::Query::Kind::info;
  const Result<msg::QueryReply> info = session.query(query, patience(invocation));
  if (!info) return report(info.error(), invocation.json, output);
  const Result<msg::QueryReply> robots = query_robots(session, patience(invocation));
  if (!robots) return report(robots.error(), invocation.json, output);
  bool good = true;
  Table table;
  table.add({"", "ROBOT", "CLOCK", "DISK", "LINK", "VERSION", "METHOD", "PROBLEM"});
  nlohmann::json documents = nlohmann::json::array();
  for (const msg::RobotRow& row : robots->robots) {
    const std::vector<Checked> checked = {clock_of(row), disk_of(row.state), link_of(row),
                                          version_of(row, info->info.software)};
    std::vector<std::string> problems;
    std::string all;
    for (const Checked& one : checked) {
      if (one.problem.empty()) continue;
      problems.push_back(one.problem);
      all += (all.empty() ? "" : "; ") + one.problem;
    }
    good = good && problems.empty();
    table.add({problems.empty() ? "ok" : "PROBLEM", row.description.name, checked[0].cell, checked[1].cell,
               checked[2].cell, checked[3].cell, methods_of(row), all});
    documents.push_back(document_of(row, problems));
  }
  if (invocation.json) {
    output.out << printed(nlohmann::json{{"good", good}, {"robots", std::move(documents)}}) << '\n';
  } else if (robots->robots.empty()) {
    output.out << "no robot has been heard; start one: weft-agent --name r1 --server ... --state DIR\n";
  } else {
    table.print(output.out);
  }
  return good ? Exit::done : Exit::failed;
}

}  // namespace weft::cli
