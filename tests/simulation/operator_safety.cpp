#include "tests/simulation/operator.hpp"

/// Does what people do for safety: they stop robots, press their emergency stops, walk into their way, and lay down
/// rules.
namespace weft::simulation {

/// Repeats the request until the server has carried it out, or `is_enough` of what it answers.
template <class IsEnough>
void Operator::insist(const msg::OperatorRequest& request, IsEnough&& is_enough) {
  while (true) {
    const auto reply = ask(request, 600.0);
    if (reply && is_enough(reply->outcome)) return;
    pass(std::chrono::seconds(5));
  }
}

/// Lets the robot go on, whatever happens meanwhile.
void Operator::resume(std::size_t robot) {
  msg::OperatorRequest request;
  request.kind = msg::OperatorRequest::Kind::resume;
  request.robot = fleet_.name(robot);
  insist(request, [](msg::Outcome outcome) { return outcome == msg::Outcome::done; });
}

/// Stops a robot for a while.
void Operator::stop_a_while(std::size_t robot) {
  msg::OperatorRequest request;
  request.kind = msg::OperatorRequest::Kind::stop;
  request.robot = fleet_.name(robot);
  ask(request);
  pass(from_seconds(random_.uniform(1.0, 60.0)));
  resume(robot);
}

/// Walks into a robot's way so that its base stops, or presses its emergency stop, and resumes it some time after
/// that is released.
void Operator::press_a_while(std::size_t robot) {
  const bool is_emergency = random_.chance(0.5);
  fleet_.press(robot, is_emergency ? Safety::emergency_stop : Safety::protective_stop);
  pass(from_seconds(random_.uniform(5.0, 40.0)));
  fleet_.press(robot, Safety::ok);
  if (!is_emergency) return;
  pass(from_seconds(random_.uniform(1.0, 40.0)));
  resume(robot);
}

/// Closes a stretch of the map by a rule, or slows who drives there, and takes the rule away again.
void Operator::rule_a_while() {
  const Removal places = fleet_.some_places(random_);
  if (places.empty() || places.places.front().first == places.places.front().last) return;
  const Stretch& stretch = places.places.front();
  const bool closes = random_.chance(0.5);
  msg::OperatorRequest request;
  request.kind = msg::OperatorRequest::Kind::rule_put;
  request.rule.name = closes ? "closed" : "slow";
  request.rule.kind = closes ? RuleKind::closed : RuleKind::speed;
  request.rule.value = closes ? 0.0 : random_.uniform(0.1, 0.4);
  request.rule.spans = {{{stretch.experience, stretch.first}, {stretch.experience, stretch.last}}};
  fleet_.ledger().ruled(true);
  ask(request);
  pass(from_seconds(random_.uniform(10.0, 120.0)));
  request.kind = msg::OperatorRequest::Kind::rule_remove;
  insist(request, [](msg::Outcome outcome) { return outcome != msg::Outcome::failed; });
  fleet_.ledger().ruled(false);
}

}  // namespace weft::simulation
