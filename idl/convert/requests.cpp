#include "idl/convert/common.hpp"
#include "idl/convert/limits.hpp"
#include "idl/convert/messages.hpp"

namespace weft::convert {

idl::OperatorRequest to_idl(const msg::OperatorRequest& message) {
  idl::OperatorRequest wire;
  wire.header(to_idl(message.header));
  wire.request(message.request);
  wire.kind(static_cast<std::uint8_t>(message.kind));
  wire.robot(message.robot);
  wire.label(message.label);
  wire.place(to_idl(message.place));
  wire.goal(message.goal.bytes);
  wire.along(to_idl(message.along));
  return wire;
}

Result<msg::OperatorRequest> from_idl(const idl::OperatorRequest& wire) {
  using Kind = msg::OperatorRequest::Kind;
  Reading reading("OperatorRequest");
  msg::OperatorRequest value;
  value.header = from_idl(wire.header(), reading.in("header"));
  value.request = wire.request();
  value.kind = reading.choice("kind", wire.kind(), Kind::goal_send, Kind::clear);
  value.robot = reading.text("robot", wire.robot(), kNameLength);
  value.label = reading.text("label", wire.label(), kNameLength);
  value.place = from_idl(wire.place());
  value.goal = id_from<GoalId>(wire.goal());
  const bool needs_goal = value.kind == Kind::goal_send || value.kind == Kind::goal_cancel;
  reading.require(!needs_goal || value.goal, "goal", "must not be none");
  value.along = from_idl(wire.along(), reading.in("along"));
  return reading.finish(std::move(value));
}

idl::OperatorReply to_idl(const msg::OperatorReply& message) {
  idl::OperatorReply wire;
  wire.header(to_idl(message.header));
  wire.to(message.to.bytes);
  wire.request(message.request);
  wire.outcome(static_cast<std::uint8_t>(message.outcome));
  wire.message(message.message);
  wire.goal(message.goal.bytes);
  wire.place(to_idl(message.place));
  wire.experience(message.experience.value);
  return wire;
}

Result<msg::OperatorReply> from_idl(const idl::OperatorReply& wire) {
  Reading reading("OperatorReply");
  msg::OperatorReply value;
  value.header = from_idl(wire.header(), reading.in("header"));
  value.to = reading.some("to", id_from<PeerId>(wire.to()));
  value.request = wire.request();
  value.outcome = reading.choice("outcome", wire.outcome(), msg::Outcome::done, msg::Outcome::failed);
  value.message = reading.text("message", wire.message(), kTextLength);
  value.goal = id_from<GoalId>(wire.goal());
  value.place = from_idl(wire.place());
  value.experience = ExperienceId{wire.experience()};
  return reading.finish(std::move(value));
}

idl::Query to_idl(const msg::Query& message) {
  idl::Query wire;
  wire.header(to_idl(message.header));
  wire.request(message.request);
  wire.kind(static_cast<std::uint8_t>(message.kind));
  wire.goal(message.goal.bytes);
  wire.robot(message.robot);
  wire.newest(message.newest.value);
  wire.most(message.most);
  return wire;
}

Result<msg::Query> from_idl(const idl::Query& wire) {
  using Kind = msg::Query::Kind;
  Reading reading("Query");
  msg::Query value;
  value.header = from_idl(wire.header(), reading.in("header"));
  value.request = wire.request();
  value.kind = reading.choice("kind", wire.kind(), Kind::robots, Kind::log);
  value.goal = id_from<GoalId>(wire.goal());
  value.robot = reading.text("robot", wire.robot(), kNameLength);
  value.newest = Revision{wire.newest()};
  value.most = wire.most();
  return reading.finish(std::move(value));
}

}  // namespace weft::convert
