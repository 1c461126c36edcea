#include <fstream>
#include <iterator>

#include "clients/cli/commands.hpp"

namespace weft::cli {
namespace {
using Command = Invocation::Command;
using Kind = msg::OperatorRequest::Kind;

Result<std::vector<msg::AgentCommand::Point>> read_polyline(const std::string& file) {
  std::ifstream in(file);
  if (!in) return fail(ErrorCode::invalid, file + ": cannot be read; --along wants a file with 'x y' a line");
  const std::string text{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
  return parse_polyline(text, file);
}

Kind kind_of(Command command, bool here) {
  switch (command) {
    case Command::teach_start:
      return Kind::teach_start;
    case Command::teach_stop:
      return Kind::teach_stop;
    case Command::localise:
      return Kind::localise;
    case Command::resume:
      return Kind::resume;
    case Command::robot_clear:
      return Kind::clear;
    case Command::robot_forget:
      return Kind::forget;
    case Command::robot_rename:
      return Kind::rename;
    case Command::map_unlabel:
      return Kind::label_remove;
    case Command::map_relabel:
      return Kind::label_rename;
    case Command::hold:
      return Kind::hold;
    case Command::unhold:
      return Kind::unhold;
    case Command::map_label:
      return here ? Kind::label_here : Kind::label;
    default:
      return Kind::stop;
  }
}

Result<msg::OperatorRequest> request_for(const Invocation& invocation) {
  const bool here = invocation.place == "here";
  msg::OperatorRequest request;
  request.kind = kind_of(invocation.command, here);
  request.robot = invocation.robot;
  request.label = invocation.name;
  request.new_label = invocation.new_name;
  request.is_sure = invocation.is_sure;
  if (!invocation.file.empty()) {
    Result<std::vector<msg::AgentCommand::Point>> along = read_polyline(invocation.file);
    if (!along) return fail(along.error());
    request.along = std::move(*along);
  }
  if (invocation.place.empty() || here) return request;
  if (const std::optional<PlaceId> place = parse_place_id(invocation.place); place.has_value()) {
    request.place = *place;
  } else if (invocation.command == Command::localise) {
    request.label = invocation.place;
  } else {
    return fail(ErrorCode::invalid, "'" + invocation.place +
                                        "' is no place; write <16 hex digits>:<index> as `weft map export` and `weft "
                                        "robots` show it, or here --robot ROBOT");
  }
  return request;
}
}  // namespace

Exit run_operator(Session& session, const Invocation& invocation, const Output& output) {
  Result<msg::OperatorRequest> request = request_for(invocation);
  if (!request) return report(request.error(), invocation.json, output);
  const auto say = [&](const msg::OperatorReply& now) { output.err << now.message << '\n'; };
  const Result<msg::OperatorReply> reply = session.ask(std::move(*request), patience(invocation), say);
  if (!reply) return report(reply.error(), invocation.json, output);
  if (!invocation.json) {
    for (const std::string& line : reply->findings) output.out << line << '\n';  // of each robot
  }
  const bool is_taught = reply->outcome == msg::Outcome::done && reply->experience;
  if (!invocation.replace || !is_taught) return show(*reply, invocation, output);
  if (!invocation.json) output.out << reply->message << '\n';
  Invocation replaced = invocation;
  replaced.command = Command::map_replace;
  replaced.what = to_string(reply->experience);
  return run_map_work(session, replaced, output);
}

}  // namespace weft::cli
