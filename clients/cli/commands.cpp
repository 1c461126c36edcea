#include "clients/cli/commands.hpp"

#include <algorithm>
#include <array>
#include <chrono>

namespace weft::cli {
namespace {
using namespace std::chrono_literals;
using Command = Invocation::Command;

constexpr Duration kReach = 10s;  ///< discovery across vendors takes seconds on a busy machine
constexpr Duration kSoon = 15s;
constexpr Duration kAMinute = 60s;

/// Describes a command that asks the server: the function that does it, and how long an answer may take by default.
struct Asking {
  Command command;
  Exit (*run)(Session&, const Invocation&, const Output&);
  Duration patience;
};
constexpr std::array kAskings{
    Asking{Command::robots, run_robots, kSoon},
    Asking{Command::teach_start, run_operator, 40s},
    Asking{Command::teach_stop, run_operator, 40s},
    Asking{Command::teach_report, run_teach_report, kSoon},
    Asking{Command::localise, run_operator, 120s},  // the robot waits for its map and searches it
    Asking{Command::stop, run_operator, kSoon},
    Asking{Command::resume, run_operator, kSoon},
    Asking{Command::robot_clear, run_operator, kSoon},
    Asking{Command::robot_counts, run_counts, kSoon},
    Asking{Command::robot_forget, run_operator, kSoon},
    Asking{Command::robot_rename, run_operator, kSoon},
    Asking{Command::map_label, run_operator, 40s},
    Asking{Command::map_unlabel, run_operator, kSoon},
    Asking{Command::map_relabel, run_operator, kSoon},
    Asking{Command::map_info, run_map, kSoon},
    Asking{Command::map_list, run_map_list, kSoon},
    Asking{Command::map_draw, run_map, kAMinute},
    Asking{Command::map_export, run_map, kAMinute},
    Asking{Command::map_log, run_history, kSoon},
    Asking{Command::map_diff, run_history, kAMinute},
    Asking{Command::map_rollback, run_map_work, kAMinute},
    Asking{Command::map_undo, run_map_work, kAMinute},
    Asking{Command::map_quarantine, run_map_work, kAMinute},
    Asking{Command::map_apart, run_apart, kAMinute},
    Asking{Command::map_replace, run_map_work, kAMinute},
    Asking{Command::map_prune, run_map_work, kAMinute},
    Asking{Command::map_compact, run_map_work, kAMinute},
    Asking{Command::map_snapshot, run_map_work, kAMinute},
    Asking{Command::map_check, run_map_work, kAMinute},
    Asking{Command::map_stats, run_map_work, kAMinute},
    Asking{Command::map_import, run_import, kAMinute},
    Asking{Command::goal_send, run_goals, kSoon},
    Asking{Command::goal_list, run_goals, kSoon},
    Asking{Command::goal_show, run_goals, kSoon},
    Asking{Command::goal_watch, run_goals, 24h},
    Asking{Command::goal_cancel, run_goals, kSoon},
    Asking{Command::goal_hand_over, run_goals, kSoon},
    Asking{Command::goal_why, run_goals, kSoon},
    Asking{Command::rule_add, run_rules, kAMinute},
    Asking{Command::rule_list, run_rule_list, kAMinute},
    Asking{Command::rule_refresh, run_refresh, kAMinute},
    Asking{Command::rule_remove, run_rules, kAMinute},
    Asking{Command::edge_close, run_rules, kAMinute},
    Asking{Command::edge_open, run_rules, kAMinute},
    Asking{Command::hold, run_operator, kAMinute},
    Asking{Command::unhold, run_operator, kAMinute},
    Asking{Command::map_register, run_register, kAMinute},
    Asking{Command::events, run_events, kSoon},
    Asking{Command::alarms, run_alarms, kSoon},
    Asking{Command::doctor_network, run_network, kSoon},
    Asking{Command::doctor_fleet, run_doctor_fleet, kSoon},
};

const Asking* asking_for(Command command) {
  const auto* const found = std::ranges::find(kAskings, command, &Asking::command);
  return found == kAskings.end() ? nullptr : found;
}

}  // namespace

Duration patience(const Invocation& invocation) {
  if (invocation.timeout_s.has_value()) return from_seconds(*invocation.timeout_s);
  const Asking* const asking = asking_for(invocation.command);
  return asking == nullptr ? kSoon : asking->patience;
}

Duration reach(const Invocation& invocation) {
  return std::min(patience(invocation), kReach);
}

namespace {
constexpr int kOneLine = -1;  // an error may end documents that follow one another, each a line

/// Makes what every command prints with --json when it was not done, whoever said no.
nlohmann::json error_document(const std::string& code, const std::string& message, int exit) {
  return {{"error", {{"code", code}, {"message", message}}}, {"exit", exit}};
}
}  // namespace

int report(const NotRun& not_run, const Output& output) {
  (not_run.exit_code == 0 ? output.out : output.err) << not_run.text;
  if (not_run.json && not_run.exit_code != 0) {
    constexpr std::string_view before = "weft: ";
    std::string message = not_run.text.substr(not_run.text.starts_with(before) ? before.size() : 0);
    while (message.ends_with('\n')) message.pop_back();
    output.out << printed(error_document(to_string(ErrorCode::invalid), message, not_run.exit_code), kOneLine)
               << '\n';
  }
  return not_run.exit_code;
}

Exit report(const Error& error, bool json, const Output& output) {
  return report(error, exit_of(error), json, output);
}

Exit report_offline(const Error& error, bool json, const Output& output) {
  const Exit exit = exit_of(error);
  return report(error, exit == Exit::unreached ? Exit::failed : exit, json, output);
}

Exit report(const Error& error, Exit exit, bool json, const Output& output) {
  output.err << "weft: " << error.message << '\n';
  if (json)
    output.out << printed(error_document(to_string(error.code), error.message, static_cast<int>(exit)), kOneLine)
               << '\n';
  return exit;
}

Names names_of(const std::vector<msg::RobotRow>& robots) {
  Names names;
  for (const msg::RobotRow& row : robots) names[row.description.header.sender] = row.description.name;
  return names;
}

Result<msg::QueryReply> query_robots(Session& session, Duration at_most) {
  msg::Query query;
  query.kind = msg::Query::Kind::robots;
  return session.query(query, at_most);
}

Exit show(const msg::OperatorReply& reply, const Invocation& invocation, const Output& output) {
  const Exit exit = exit_of(reply.outcome);
  if (invocation.json) {
    static constexpr std::array<const char*, 6> kOutcomes = {"",        "done",   "accepted",
                                                             "refused", "failed", "under way"};
    const char* const outcome = kOutcomes.at(static_cast<std::size_t>(reply.outcome));
    nlohmann::json document = exit == Exit::done ? nlohmann::json{{"outcome", outcome}, {"message", reply.message}}
                                                 : error_document(outcome, reply.message, static_cast<int>(exit));
    if (reply.goal) document["goal"] = to_string(reply.goal);
    if (reply.place) document["place"] = to_string(reply.place);
    if (reply.experience) document["experience"] = to_string(reply.experience);
    if (reply.revision.value != 0) document["revision"] = reply.revision.value;
    if (!reply.findings.empty()) document["findings"] = reply.findings;
    for (const auto& [name, count] : reply.counts) document["counts"][name] = count;
    output.out << printed(document) << '\n';
  }
  if (exit != Exit::done) {
    output.err << "weft: " << reply.message << '\n';
  } else if (!invocation.json) {
    output.out << reply.message << '\n';
  }
  return exit;
}

bool needs_server(Command command) {
  return command != Command::file_info && command != Command::file_convert && command != Command::map_restore &&
         command != Command::calibrate;
}

Exit run_offline(const Invocation& invocation, const Output& output) {
  if (invocation.command == Command::calibrate) return run_calibrate(invocation, output);
  return invocation.command == Command::map_restore ? run_restore(invocation, output) : run_file(invocation, output);
}

Exit run(Session& session, const Invocation& invocation, const Output& output) {
  if (!needs_server(invocation.command)) return run_offline(invocation, output);
  if (invocation.command == Command::bundle) return run_bundle(session, invocation, output);
  const Result<msg::Hello> server = session.connect(reach(invocation));
  if (!server) return report(server.error(), invocation.json, output);
  if (invocation.command == Command::doctor) return run_doctor(session, *server, invocation, output);
  if (const Asking* const asking = asking_for(invocation.command)) return asking->run(session, invocation, output);
  return report({ErrorCode::internal, "no such command"}, invocation.json, output);
}

}  // namespace weft::cli
