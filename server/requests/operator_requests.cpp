#include "server/requests/operator_requests.hpp"

#include <algorithm>
#include <utility>

#include "core/text.hpp"
#include "server/base/outcome.hpp"

namespace weft::server {
namespace {

using Kind = msg::OperatorRequest::Kind;

}  // namespace

void OperatorRequests::answer(const Key& key, msg::OperatorReply reply) {
  reply.to = key.first;
  reply.message = clipped(std::move(reply.message));
  reply.request = key.second;
  ledger_.answered(key, reply);
  context_.out.send(std::move(reply));
}

void OperatorRequests::answer(const Key& key, msg::Outcome outcome, const std::string& message) {
  msg::OperatorReply reply;
  reply.outcome = outcome;
  reply.message = message;
  answer(key, std::move(reply));
}

void OperatorRequests::on_request(const msg::OperatorRequest& request, const std::string& who, Now now) {
  const Key key = {request.header.sender, request.request};
  switch (ledger_.see(key)) {
    case RequestLedger::Seen::under_way:
      return;
    case RequestLedger::Seen::answered:
      context_.out.send(ledger_.answer(key));
      return;
    case RequestLedger::Seen::fresh:
      break;
  }
  switch (request.kind) {
    case Kind::goal_send:
      if (request.on_plan) return send_to_plan(key, request, who, now);
      answer(key, dispatcher_.send(request, who, now));
      return;
    case Kind::goal_cancel:
      answer(key, dispatcher_.cancel(request.goal, who, now));
      return;
    case Kind::goal_hand_over:
      answer(key, dispatcher_.hand_over(request.goal, who, now));
      return;
    case Kind::stop:
    case Kind::resume:
      stop_or_resume(key, request, who, now);
      return;
    case Kind::label:
      label(key, request, who, now);
      return;
    case Kind::label_here:
      label_here(key, request, who, now);
      return;
    case Kind::label_remove:
      remove_label(key, request, who, now);
      return;
    case Kind::label_rename:
      rename_label(key, request, who, now);
      return;
    case Kind::clear:
      clear(key, request, who, now);
      return;
    case Kind::forget:
    case Kind::rename:
      forget_or_rename(key, request, who, now);
      return;
    case Kind::teach_start:
    case Kind::teach_stop:
    case Kind::teach_report:
    case Kind::robot_counts:
    case Kind::localise:
      command_one(key, request, who, now);
      return;
    case Kind::rollback:
    case Kind::undo:
    case Kind::quarantine:
    case Kind::apart:
    case Kind::rule_put:
    case Kind::rule_remove:
    case Kind::plan_remove:
      answer(key, editor_.on_request(request, who, now));
      return;
    case Kind::plan_register:
      if (std::optional<msg::OperatorReply> at_once = registering_.begin(key, request, who, now)) {
        answer(key, *std::move(at_once));
      }
      return;
    case Kind::hold:
    case Kind::unhold:
      hold_or_free(key, request, who, now);
      return;
    case Kind::replace:
    case Kind::prune:
    case Kind::compact:
    case Kind::snapshot:
    case Kind::snapshot_verified:
    case Kind::check:
    case Kind::stats:
      if (std::optional<msg::OperatorReply> at_once = jobs_.begin(key, request, who, now)) {
        answer(key, *std::move(at_once));
      }
      return;
  }
}

void OperatorRequests::tick(Now now) {
  commands_.tick(now.steady);
  answer_overdue(now.steady);
  for (auto& [key, reply] : registering_.tick(now)) answer(key, std::move(reply));
  for (auto& [key, reply] : jobs_.tick(now)) tell(key, std::move(reply));
  if (const auto due = awaited_labels_.next(); due && *due <= now.steady) settle_labels(now);
  for (auto& [key, reply] : awaited_labels_.tick(now.steady)) tell(key, std::move(reply));
}

/// Answers, unless it is still under way: that is said, and not kept.
void OperatorRequests::tell(const Key& key, msg::OperatorReply reply) {
  if (reply.outcome != msg::Outcome::under_way) return answer(key, std::move(reply));
  reply.to = key.first;
  reply.request = key.second;
  context_.out.send(std::move(reply));
}

std::optional<SteadyTime> OperatorRequests::next() const {
  std::optional<SteadyTime> next = jobs_.next();
  if (!next) next = commands_.next();
  for (const auto due : {registering_.next(), awaited_labels_.next()})
    if (due) next = next ? std::min(*next, *due) : *due;
  for (const auto& [key, group] : group_commands_) next = next ? std::min(*next, group.answer_by) : group.answer_by;
  return next;
}

Result<const Robot*> OperatorRequests::reachable(const std::string& name) const {
  const Result<RobotId> id = fleet_.by_name(name);
  if (!id) return fail(id.error());
  const Robot* const robot = fleet_.find(*id);
  if (std::string why = unreachable_reason(*robot); !why.empty()) return fail(ErrorCode::unavailable, std::move(why));
  return robot;
}

Result<msg::AgentCommand> OperatorRequests::command_for(const msg::OperatorRequest& request,
                                                        const Robot& robot) const {
  msg::AgentCommand command;
  command.to = robot.id;
  command.along = request.along;
  if (request.place) command.seed = request.place;
  if (request.kind == Kind::teach_stop) {
    command.kind = msg::AgentCommand::Kind::teach_stop;
    return command;
  }
  if (request.kind == Kind::robot_counts) {
    command.kind = msg::AgentCommand::Kind::counts;
    return command;
  }
  if (request.kind == Kind::teach_report) {
    command.kind = msg::AgentCommand::Kind::teach_report;
    command.name = request.label;
    return command;
  }
  if (request.kind == Kind::teach_start) {
    if (const Goal* const goal = dispatcher_.goal_of(robot.id)) {
      return fail(ErrorCode::refused, robot.name + " has goal " + to_string(goal->id) + ": cancel it first");
    }
    const Result<void> good = request.label.empty() ? Result<void>() : check_name("experience", request.label);
    if (!good) return fail(good.error());
    command.kind = msg::AgentCommand::Kind::teach_start;
    command.name = request.label;
    if (!request.along.empty() && !robot.description->can_be_taught_along) {
      return fail(ErrorCode::refused, robot.name + "'s body (" + robot.description->body +
                                          ") has no hand that follows a polyline: teach it without --along");
    }
    return command;
  }
  command.kind = msg::AgentCommand::Kind::localise;
  if (command.seed || request.label.empty()) return command;
  const Snapshot::Labels& labels = context_.snapshots.current().labels();
  const auto label = labels.find(request.label);
  if (label == labels.end()) return fail(ErrorCode::not_found, "the map has no label " + request.label);
  command.seed = label->second;
  return command;
}

void OperatorRequests::command_one(const Key& key, const msg::OperatorRequest& request, const std::string& who,
                                   Now now) {
  const Result<const Robot*> robot = reachable(request.robot);
  if (!robot) return answer(key, msg::Outcome::refused, robot.error().message);
  if (request.place && context_.snapshots.current().place(request.place) == nullptr) {
    return answer(key, msg::Outcome::refused, "the map has no place " + to_string(request.place));
  }
  Result<msg::AgentCommand> command = command_for(request, **robot);
  if (!command) return answer(key, msg::Outcome::refused, command.error().message);
  if (request.kind == Kind::robot_counts) return send_for(key, *std::move(command), now.steady);  // changes nothing
  const char* const kind = request.kind == Kind::teach_start    ? "robot.teach_asked"
                           : request.kind == Kind::teach_stop   ? "robot.teach_end_asked"
                           : request.kind == Kind::teach_report ? "robot.report_asked"
                                                                : "robot.localise_asked";
  context_.writer.note(
      {.at = {}, .kind = kind, .robot = (*robot)->id, .goal = {}, .cause = request.label, .who = who}, now);
  send_for(key, *std::move(command), now.steady);
}

void OperatorRequests::send_for(const Key& key, msg::AgentCommand command, SteadyTime now) {
  const std::uint64_t number = commands_.give(std::move(command), now);
  asked_for_[number] = key;
  waiting_[key].commands.insert(number);
}

/// Sends a robot to the place that lies nearest to a point of a floor plan; a repeat of a goal is one whatever has
/// become of the plan since.
void OperatorRequests::send_to_plan(const Key& key, const msg::OperatorRequest& request, const std::string& who,
                                    Now now) {
  msg::OperatorRequest sent = request;
  const Eigen::Vector2d& point = request.on_plan->point;
  sent.label = fixed_number(point.x(), 2) + "," + fixed_number(point.y(), 2);
  if (!request.goal || dispatcher_.book().find(request.goal) == nullptr) {
    const Result<PlaceId> place = site_frames_.nearest(request.on_plan->plan, point);
    if (!place) return answer(key, outcome_of(place.error()), place.error().message);
    sent.place = *place;
  }
  answer(key, dispatcher_.send(sent, who, now));
}

void OperatorRequests::clear(const Key& key, const msg::OperatorRequest& request, const std::string& who, Now now) {
  const Result<RobotId> id = fleet_.by_name(request.robot);
  if (!id) return answer(key, msg::Outcome::refused, id.error().message);
  const Result<std::string> done = dispatcher_.clear(*id, request.is_sure, who, now);
  if (!done) return answer(key, outcome_of(done.error()), done.error().message);
  answer(key, msg::Outcome::done, fleet_.name_of(*id) + ": " + *done);
}

/// Holds a robot, or the places of a rule, or lets go of them; a robot goes before a rule of its name.
void OperatorRequests::hold_or_free(const Key& key, const msg::OperatorRequest& request, const std::string& who,
                                    Now now) {
  const Result<RobotId> robot = fleet_.by_name(request.robot);
  if (!robot && robot.error().code != ErrorCode::not_found) {
    return answer(key, outcome_of(robot.error()), robot.error().message);
  }
  if (!robot) return answer(key, editor_.on_request(request, who, now));
  const bool holds = request.kind == Kind::hold;
  const Result<std::string> done = fleet_.hold(*robot, holds, who, now);
  if (!done) return answer(key, outcome_of(done.error()), done.error().message);
  dispatcher_.held_or_freed(*robot);
  answer(key, msg::Outcome::done, *done);
}

/// Clears a robot before it forgets it: what it holds is free, and its goal fails.
void OperatorRequests::forget_or_rename(const Key& key, const msg::OperatorRequest& request, const std::string& who,
                                        Now now) {
  const Result<RobotId> id = fleet_.by_name(request.robot);
  if (!id) return answer(key, msg::Outcome::refused, id.error().message);
  const std::string name = fleet_.name_of(*id) + " (" + to_string(*id) + ")";
  const bool forgets = request.kind == Kind::forget;
  if (forgets && fleet_.find(*id)->silent) {
    const Result<std::string> cleared = dispatcher_.clear(*id, false, who, now);
    if (!cleared) return answer(key, outcome_of(cleared.error()), cleared.error().message);
  }
  const Result<void> done = forgets ? fleet_.forget(*id, who, now) : fleet_.rename(*id, request.label, who, now);
  if (!done) return answer(key, outcome_of(done.error()), done.error().message);
  if (forgets) {
    dispatcher_.fail_waiting_for(*id, "its robot " + name + " was forgotten", who, now);
    awaited_labels_.robot_gone(*id, "its robot " + name + " was forgotten");
    settle_labels(now);
  }
  answer(key, msg::Outcome::done,
         name + (forgets ? " is forgotten; what it taught stays" : " is called " + request.label + " from now on"));
}

}  // namespace weft::server
