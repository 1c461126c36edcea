#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <numbers>

#include "clients/cli/commands.hpp"
#include "clients/cli/table.hpp"
#include "clients/cli/wait_chain.hpp"

namespace weft::cli {
namespace {

std::string where(const msg::RobotState& state) {
  if (!state.localised && state.mode == msg::RobotMode::lost && state.place.experience)
    return "lost by " + to_string(state.place);
  if (!state.localised) return "unknown";
  return to_string(state.place) + " +" + fixed(distance_m(state.place_from_robot), 2) + " m";
}

/// Returns where the robot stands on a registered floor plan: "hall 12.40,3.10 90 deg".
std::string on_plan(const msg::RobotRow& row) {
  if (row.plan.empty()) return "-";
  const Pose2& pose = row.plan_from_robot;
  return row.plan + " " + fixed(pose.x, 2) + "," + fixed(pose.y, 2) + " " +
         fixed(pose.heading * 180.0 / std::numbers::pi, 0) + " deg";
}

std::string doing(const msg::RobotState& state) {
  if (state.experience) return "experience " + to_string(state.experience);
  if (state.goal) return "goal " + to_string(state.goal).substr(0, 8);
  return "-";
}

/// Returns what the robot's window and its contents took on the wire since the server started, MiB.
std::string sent_to(const msg::RobotRow& row) {
  return fixed(static_cast<double>(row.window_bytes) / bytes_a_mib, 1) + " + " +
         fixed(static_cast<double>(row.content_bytes) / bytes_a_mib, 1) + " MiB";
}

std::string held_by(const msg::RobotState& state) {
  return fixed(static_cast<double>(state.memory_bytes) / bytes_a_mib, 1) + " of " +
         fixed(static_cast<double>(state.memory_cap_bytes) / bytes_a_mib, 0) + " MiB";
}

/// Returns what the robot's battery holds, as it said last.
std::string charge(const msg::RobotRow& row) {
  if (!row.power.header.sender) return "-";
  const std::string percent = fixed(100.0 * row.power.share, 0) + " %";
  return row.power.is_charging ? percent + ", charging" : percent;
}

std::string why(const msg::RobotRow& row) {
  const std::string stands = row.standstill.empty()     ? ""
                             : row.state.reason.empty() ? "in a standstill"
                                                        : "; in a standstill";
  const std::string held = std::string(row.is_deaf ? " (hears nothing of the server)" : "") +
                           (row.held_by.empty() ? "" : " (held by " + row.held_by + ")");
  if (row.state.mode != msg::RobotMode::lost) return row.state.reason + stands + held;
  return row.state.reason + stands + "; needs help: weft localise " + row.description.name + " --at LABEL";
}

}  // namespace

std::string fixed(double value, int digits) {
  std::array<char, 64> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

Exit run_robots(Session& session, const Invocation& invocation, const Output& output) {
  const Result<msg::QueryReply> reply = query_robots(session, patience(invocation));
  if (!reply) return report(reply.error(), invocation.json, output);
  std::vector<msg::RobotRow> rows = reply->robots;
  std::ranges::stable_sort(rows, {}, [](const msg::RobotRow& row) { return row.description.name; });
  if (invocation.json) {
    nlohmann::json all = nlohmann::json::array();
    const Names names = names_of(rows);
    for (const msg::RobotRow& row : rows) all.push_back(to_json(row, names));
    output.out << printed(nlohmann::json{{"robots", std::move(all)}}) << '\n';
    return Exit::done;
  }
  if (reply->robots.empty()) {
    output.out << "no robot has been heard; start one: weft-agent --name r1 --server ... --state DIR\n";
    return Exit::done;
  }
  Table table;
  const bool is_on_plan = std::ranges::any_of(rows, [](const msg::RobotRow& row) { return !row.plan.empty(); });
  table.add({"ROBOT", "MODE", "PLACE", "DOES", "HEARD", "SENT", "HOLDS", "CHARGE", "REASON"});
  if (is_on_plan) table.into_last(3, "ON PLAN");
  for (const msg::RobotRow& row : rows) {
    table.add({row.description.name, row.is_heard ? msg::to_string(row.state.mode) : "silent", where(row.state),
               doing(row.state), fixed(row.silent_s, 1) + " s ago", sent_to(row), held_by(row.state), charge(row),
               why(row)});
    if (is_on_plan) table.into_last(3, on_plan(row));
  }
  table.print(output.out);
  for (const std::string& text : standstills(rows)) output.out << "standstill: " << text << '\n';
  return Exit::done;
}

}  // namespace weft::cli
