#include <cmath>

#include "clients/cli/findings.hpp"
#include "clients/cli/table.hpp"
#include "clients/cli/wait_chain.hpp"

namespace weft::cli {
namespace {

constexpr double kGiB = 1024.0 * 1024.0 * 1024.0;

std::vector<Finding> of_server(const msg::Hello& server, const msg::MapInfo& info, const std::string& vendor) {
  std::vector<Finding> found;
  found.push_back({"server", true,
                   "reached: " + server.name + ", epoch " + std::to_string(info.epoch.value) + ", revision " +
                       std::to_string(info.revision.value)});
  found.push_back({"vendors", true, "server " + info.vendor + ", this " + vendor});
  const bool same = info.software == WEFT_VERSION;
  found.push_back(
      {"versions", same,
       "server " + info.software + ", this " WEFT_VERSION + (same ? "" : ": update the older one when it suits")});
  const bool takes = info.stopped.empty();
  found.push_back({"store", takes,
                   takes ? "takes what is handed in" : "takes nothing since its last write failed: " + info.stopped});
  const bool room = info.disk_free_bytes >= msg::kDiskLowBytes;
  found.push_back({"disk", room,
                   fixed(static_cast<double>(info.disk_free_bytes) / kGiB, 1) + " GiB free at the server" +
                       (room ? "" : ": make room, or batches will be refused")});
  const bool joined = info.unjoined.empty();
  found.push_back({"traffic", joined, joined ? "all robots are in one part of the map" : info.unjoined});
  for (const auto& [what, times] : info.counters) {
    found.push_back({"counted", true, std::to_string(times) + " x " + what});
  }
  return found;
}

/// Returns what is found of one robot. `has_places`: the map has places in which a robot could localise itself.
std::vector<Finding> of_robot(const msg::RobotRow& row, const std::string& server_software, bool has_places) {
  const std::string name = "robot " + row.description.name;
  std::vector<Finding> found;
  const bool heard = row.is_heard && row.silent_s <= kSilent_s;
  found.push_back({name, heard,
                   heard ? row.vendor + ", " + msg::to_string(row.state.mode)
                         : "not heard for " + fixed(row.silent_s, 0) + " s: is its agent running?"});
  if (!row.software.empty()) {  // it has said hello since the server's start
    const bool same = row.software == server_software;
    found.push_back({name, same,
                     "version " + row.software +
                         (same ? "" : ", the server's " + server_software + ": update the older one when it suits")});
  }
  const bool close = std::abs(row.clock_skew_s) <= msg::kClockOff_s;
  found.push_back({name, close,
                   "clock " + fixed(row.clock_skew_s * 1000.0, 0) + " ms ahead of the server's" +
                       (close ? "" : ": run an NTP client there; records will not line up")});
  const bool able = row.state.mode != msg::RobotMode::faulted && row.state.mode != msg::RobotMode::lost;
  if (!able) found.push_back({name, false, row.state.reason + ": see `weft goal why " + row.description.name + "`"});
  const bool knows = row.state.localised || row.state.mode == msg::RobotMode::teaching;
  if (able && heard && !knows && has_places) {
    found.push_back({name, false,
                     "does not know where it is: weft localise " + row.description.name +
                         " --at LABEL, or move it near a place that was taught"});
  }
  // What an agent notices of its mount stands as the reason of one that goes on.
  if (able && row.state.reason.starts_with("its camera")) found.push_back({name, false, row.state.reason});
  return found;
}

/// Finds goals that have not got on for a while, and why; those that queue behind another goal are not reported.
std::vector<Finding> of_goals(const std::vector<Goal>& goals, WallTime now) {
  constexpr double kLong = 60.0;  // seconds
  std::vector<Finding> found;
  std::size_t under_way = 0;
  for (const Goal& goal : goals) {
    if (is_terminal(goal.state) || goal.history.empty()) continue;
    ++under_way;
    const GoalEvent& last = goal.history.back();
    const double since_s = seconds(now - last.at);
    const bool waits = goal.state == GoalState::pending || goal.state == GoalState::assigned ||
                       goal.state == GoalState::paused || last.cause.find(" waits ") != std::string::npos;
    const bool is_queued = last.cause.find("come first") != std::string::npos;
    if (!waits || is_queued || since_s < kLong) continue;
    const std::string id = to_string(goal.id).substr(0, 8);
    found.push_back({"goal " + id, false,
                     "to " + goal.label + " is " + to_string(goal.state) + " for " + fixed(since_s, 0) +
                         " s: " + last.cause + "; see `weft goal why " + id + "`"});
  }
  if (found.empty()) found.push_back({"goals", true, std::to_string(under_way) + " under way, none is stuck"});
  return found;
}

}  // namespace

Exit run_doctor(Session& session, const msg::Hello& server, const Invocation& invocation, const Output& output) {
  msg::Query query;
  query.kind = msg::Query::Kind::info;
  const Result<msg::QueryReply> info = session.query(query, patience(invocation));
  if (!info) return report(info.error(), invocation.json, output);
  const Result<msg::QueryReply> robots = query_robots(session, patience(invocation));
  if (!robots) return report(robots.error(), invocation.json, output);
  query.kind = msg::Query::Kind::goals;
  const Result<msg::QueryReply> goals = session.query(query, patience(invocation));
  if (!goals) return report(goals.error(), invocation.json, output);
  std::vector<Finding> findings = of_server(server, info->info, session.vendor());
  for (const msg::RobotRow& row : robots->robots) {
    for (Finding& finding : of_robot(row, info->info.software, info->info.places > 0))
      findings.push_back(std::move(finding));
  }
  for (const std::string& text : standstills(robots->robots)) findings.push_back({"standstill", false, text});
  for (Finding& finding : of_goals(goals->goals, session.world().wall())) findings.push_back(std::move(finding));
  return show(findings,
              {{"server", to_json(info->info)},
               {"client", {{"vendor", session.vendor()}, {"software", WEFT_VERSION}}},
               {"robots", robots->robots.size()}},
              invocation.json, output);
}

}  // namespace weft::cli
