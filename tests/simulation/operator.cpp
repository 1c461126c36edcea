#include "tests/simulation/operator.hpp"

#include <algorithm>

namespace weft::simulation {

void Operator::pass(Duration time) {
  constexpr Duration most = std::chrono::seconds(2);
  const SteadyTime end = fleet_.now() + time;
  while (fleet_.now() < end) {
    chaos_.play();
    fleet_.run_until(std::min(end, fleet_.now() + most));
  }
}

std::optional<msg::OperatorReply> Operator::ask(msg::OperatorRequest request, double give_up_s) {
  request.request = random_.next();
  return repeat(request, give_up_s);
}

std::optional<msg::OperatorReply> Operator::repeat(const msg::OperatorRequest& request, double give_up_s) {
  const SteadyTime end = fleet_.now() + from_seconds(give_up_s);
  while (fleet_.now() < end) {
    fleet_.send(request);
    for (int i = 0; i < 8; ++i) {
      pass(std::chrono::milliseconds(250));
      for (const msg::OperatorReply& reply : fleet_.take_replies()) {
        if (reply.request == request.request && reply.outcome != msg::Outcome::under_way) return reply;
      }
    }
  }
  return std::nullopt;
}

bool Operator::give_up(const std::string& what, const std::optional<msg::OperatorReply>& reply) {
  trouble_ = what + ": " + (reply ? reply->message : "no answer");
  return false;
}

void Operator::send_goal(const std::string& label, const std::string& robot) {
  msg::OperatorRequest request;
  request.kind = msg::OperatorRequest::Kind::goal_send;
  request.label = label;
  request.robot = robot;
  for (std::uint8_t& byte : request.goal.bytes) byte = static_cast<std::uint8_t>(random_.next());
  ++goals_sent_;
  const auto reply = ask(request);
  // Not answered is not refused: it may have been taken all the same.
  if (!reply || reply->outcome != msg::Outcome::refused) open_[request.goal] = {label, {}, fleet_.now()};
  if (reply && reply->goal && reply->outcome != msg::Outcome::refused) ++goals_accepted_;
}

/// Takes a stretch of the map out, with who drives there, and puts it back. If the server ends before it answers, the
/// request when repeated hears that nothing is left to take out; the edit is then found in the log.
void Operator::edit_a_while() {
  msg::OperatorRequest request;
  request.kind = msg::OperatorRequest::Kind::quarantine;
  request.work.what = fleet_.some_places(random_);
  if (request.work.what.empty()) return;
  fleet_.ledger().map_edited(true);
  const auto edited = ask(request, 3600.0);
  const bool is_done = edited && edited->outcome == msg::Outcome::done;
  const Revision revision = is_done ? edited->revision : quarantined();
  if (revision != Revision{}) {
    pass(from_seconds(random_.uniform(1.0, 60.0)));
    request.kind = msg::OperatorRequest::Kind::undo;
    request.work.what = {};
    request.work.revision = revision;
    while (true) {
      const auto undone = ask(request, 600.0);
      if (undone && undone->outcome != msg::Outcome::failed) break;
      pass(std::chrono::seconds(5));
    }
  }
  fleet_.ledger().map_edited(false);
}

/// Does what people do most of the time.
void Operator::often(std::size_t robot) {
  switch (focus_) {
    case Focus::rules:
      return rule_a_while();
    case Focus::stops:
      return press_a_while(robot);
    case Focus::teaching:
      teach_more(robot);
      return;
    case Focus::none:
      return;
  }
}

void Operator::errand() {
  const double what = random_.uniform();
  const std::size_t robot = random_.below(fleet_.robots());
  if (focus_ != Focus::none && random_.chance(0.7)) {
    return often(robot);
  }
  if (what < 0.70) {
    auto label = stations_.begin();
    std::advance(label, static_cast<std::ptrdiff_t>(random_.below(stations_.size())));
    // Mostly where there is room; now and then where somebody stands, or is going.
    const std::string room = random_.chance(0.8) ? free_station() : "";
    send_goal(room.empty() ? label->first : room, random_.chance(0.7) ? fleet_.name(robot) : "");
  } else if (what < 0.78 && !open_.empty()) {
    auto open = open_.begin();
    std::advance(open, static_cast<std::ptrdiff_t>(random_.below(open_.size())));
    msg::OperatorRequest request;
    request.kind = msg::OperatorRequest::Kind::goal_cancel;
    request.goal = open->first;
    ask(request);
  } else if (what < 0.85) {
    stop_a_while(robot);
  } else if (what < 0.88) {
    press_a_while(robot);
  } else if (what < 0.92) {
    edit_a_while();
  } else if (what < 0.94) {
    rule_a_while();
  } else if (what < 0.97) {
    teach_more(robot);
  } else if (!fleet_.state(robot).localised) {
    msg::OperatorRequest request;
    request.kind = msg::OperatorRequest::Kind::localise;
    request.robot = fleet_.name(robot);
    ask(request);
  }
}

}  // namespace weft::simulation
