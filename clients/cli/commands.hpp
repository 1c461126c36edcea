#pragma once
#include <ostream>
#include <string>

#include "clients/cli/exit.hpp"
#include "clients/cli/invocation.hpp"
#include "clients/cli/json.hpp"
#include "clients/cli/session.hpp"

namespace weft::cli {

/// Holds the streams that a command's words go to. With --json exactly one document goes to `out`, errors included.
struct Output {
  std::ostream& out;
  std::ostream& err;
};

/// Connects and does what was asked. Files named in the invocation are read and written here.
Exit run(Session& session, const Invocation& invocation, const Output& output);

/// Returns whether a command talks to a server; the others are done by `run_offline`.
bool needs_server(Invocation::Command command);
/// Returns the peer as whom a command speaks: an import as the robot whose runs it says they are, so that importing
/// again is a repeat.
PeerId identity(const Invocation& invocation, const PeerId& otherwise);
Exit run_offline(const Invocation& invocation, const Output& output);
/// Makes a snapshot the map of a store's directory.
Exit run_restore(const Invocation& invocation, const Output& output);
/// Becomes `weft-agent calibrate`, which knows of cameras; returns only if there is no such program, beside this one
/// or on the PATH.
Exit run_calibrate(const Invocation& invocation, const Output& output);
/// Reads and writes files of open formats.
Exit run_file(const Invocation& invocation, const Output& output);

/// Shows help, or what is wrong with a command line: its exit code.
int report(const NotRun& not_run, const Output& output);
/// Write "weft: ..." to err, and with --json the error as a document to out; return the exit code.
Exit report(const Error& error, bool json, const Output& output);
Exit report(const Error& error, Exit exit, bool json, const Output& output);
/// Reports an error of a command that needs no server: what cannot be reached is a file, and the exit code is 1.
Exit report_offline(const Error& error, bool json, const Output& output);

// One family of commands each; connected already.
Exit run_robots(Session& session, const Invocation& invocation, const Output& output);
Exit run_operator(Session& session, const Invocation& invocation, const Output& output);
/// Shows how what a robot was taught will be found again, as a table and a picture.
Exit run_teach_report(Session& session, const Invocation& invocation, const Output& output);
/// Shows how often a robot found where it is, and what it refused.
Exit run_counts(Session& session, const Invocation& invocation, const Output& output);
Exit run_map(Session& session, const Invocation& invocation, const Output& output);
/// Show the runs of the map, the log of revisions, and what two revisions differ in.
Exit run_map_list(Session& session, const Invocation& invocation, const Output& output);
Exit run_history(Session& session, const Invocation& invocation, const Output& output);
/// Asks for the network that is wanted, page by page; says how far it is. refused: there is no such revision.
Result<Window> network_at(Session& session, const Invocation& invocation, Session::Wanted wanted,
                          const Output& output);
/// Edits the map or does upkeep of the store; long work shows how far it is.
Exit run_map_work(Session& session, const Invocation& invocation, const Output& output);
/// Records that two stretches are different floors, or lists all pairs that are.
Exit run_apart(Session& session, const Invocation& invocation, const Output& output);
/// Asks for the aparts of the map as it was at that revision; 0: as it is.
Result<std::vector<Apart>> aparts_at(Session& session, const Invocation& invocation, Revision revision);
/// Asks for what comes with the last page of the map as it was at that revision, its aparts, rules and
/// registrations; 0: as it is.
Result<NetworkPage> last_page_at(Session& session, const Invocation& invocation, Revision revision);
/// Makes the request for what is to be done to the map. invalid: what the command line names is nothing that could be
/// meant.
Result<msg::OperatorRequest> map_work(const Invocation& invocation);
/// Lists rules, where they hold, and how much of their areas they do not cover.
Exit run_rule_list(Session& session, const Invocation& invocation, const Output& output);
/// Lays down and takes away rules, and closes single edges by rules.
Exit run_rules(Session& session, const Invocation& invocation, const Output& output);
/// Takes the spans of rules anew from their areas.
Exit run_refresh(Session& session, const Invocation& invocation, const Output& output);
/// Registers a floor plan, removes its registration, or shows what is registered.
Exit run_register(Session& session, const Invocation& invocation, const Output& output);
/// Makes the request of a command on rules. invalid: what the command line names is no stretch.
Result<msg::OperatorRequest> rule_request(const Invocation& invocation);
Exit run_import(Session& session, const Invocation& invocation, const Output& output);
Exit run_goals(Session& session, const Invocation& invocation, const Output& output);
/// Shows what has happened, and with --follow what happens until it is interrupted.
Exit run_events(Session& session, const Invocation& invocation, const Output& output);
/// Shows what is wrong now: done if nothing is, failed otherwise.
Exit run_alarms(Session& session, const Invocation& invocation, const Output& output);
/// Gathers what a bug report needs into one archive; without a server what this machine has.
Exit run_bundle(Session& session, const Invocation& invocation, const Output& output);
/// Measures the network between here and the server.
Exit run_network(Session& session, const Invocation& invocation, const Output& output);
/// Shows clock, disk, link, version and method of every robot, a line each.
Exit run_doctor_fleet(Session& session, const Invocation& invocation, const Output& output);
Exit run_doctor(Session& session, const msg::Hello& server, const Invocation& invocation, const Output& output);

/// Returns the --timeout that the invocation asks for, or what suits the command.
Duration patience(const Invocation& invocation);
/// Returns how long a command looks for its server.
Duration reach(const Invocation& invocation);
Result<msg::QueryReply> query_robots(Session& session, Duration at_most);
Names names_of(const std::vector<msg::RobotRow>& robots);
/// Shows the server's reply and returns its exit code.
Exit show(const msg::OperatorReply& reply, const Invocation& invocation, const Output& output);

}  // namespace weft::cli
