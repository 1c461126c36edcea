#include "clients/cli/commands.hpp"
#include "clients/cli/teach_report.hpp"
#include "drawing/canvas.hpp"

namespace weft::cli {

Exit run_teach_report(Session& session, const Invocation& invocation, const Output& output) {
  if (!invocation.file.empty()) {
    const Result<void> named = drawing::check_picture_name(invocation.file);
    if (!named) return report(named.error(), invocation.json, output);
  }
  msg::OperatorRequest request;
  request.kind = msg::OperatorRequest::Kind::teach_report;
  request.robot = invocation.robot;
  const Result<msg::OperatorReply> reply = session.ask(std::move(request), patience(invocation));
  if (!reply) return report(reply.error(), invocation.json, output);
  if (reply->outcome != msg::Outcome::done) return show(*reply, invocation, output);
  if (invocation.json) {
    nlohmann::json stretches = nlohmann::json::array();
    for (const msg::TaughtStretch& stretch : reply->report) stretches.push_back(to_json(stretch));
    output.out << printed(nlohmann::json{{"experience", to_string(reply->experience)},
                                         {"stretches", std::move(stretches)},
                                         {"advice", advice_of(reply->report)}})
               << '\n';
  } else {
    print_report(reply->report, output.out);
  }
  if (invocation.file.empty()) return Exit::done;
  const std::string about = invocation.robot + ", experience " + to_string(reply->experience);
  if (const Result<void> drawn = draw_report(reply->report, about, invocation.file); !drawn)
    return report(drawn.error(), false, output);
  return Exit::done;
}

}  // namespace weft::cli
