#include "idl/convert/common.hpp"
#include "idl/convert/limits.hpp"
#include "idl/convert/messages.hpp"

namespace weft::convert {

idl::RouteOrder to_idl(const msg::RouteOrder& message) {
  idl::RouteOrder wire;
  wire.header(to_idl(message.header));
  wire.to(message.to.bytes);
  wire.route(to_idl(message.route));
  return wire;
}

Result<msg::RouteOrder> from_idl(const idl::RouteOrder& wire) {
  Reading reading("RouteOrder");
  msg::RouteOrder value;
  value.header = from_idl(wire.header(), reading.in("header"));
  value.to = reading.some("to", id_from<PeerId>(wire.to()));
  value.route = from_idl(wire.route(), reading.in("route"));
  return reading.finish(std::move(value));
}

idl::RouteProgress to_idl(const msg::RouteProgress& message) {
  idl::RouteProgress wire;
  wire.header(to_idl(message.header));
  wire.goal(message.goal.bytes);
  wire.route(message.route.bytes);
  wire.version(message.version);
  wire.phase(static_cast<std::uint8_t>(message.phase));
  wire.passed(message.at);
  wire.freed(message.freed);
  wire.released(message.released);
  wire.goal_from_robot(to_idl(message.goal_from_robot));
  wire.reason(message.reason);
  return wire;
}

Result<msg::RouteProgress> from_idl(const idl::RouteProgress& wire) {
  Reading reading("RouteProgress");
  msg::RouteProgress value;
  value.header = from_idl(wire.header(), reading.in("header"));
  value.goal = id_from<GoalId>(wire.goal());
  value.route = reading.some("route", id_from<RouteId>(wire.route()));
  value.version = wire.version();
  value.phase = reading.choice("phase", wire.phase(), msg::RoutePhase::accepted, msg::RoutePhase::failed);
  const auto index = [&reading](std::string_view field, std::uint32_t value_) {
    reading.require(value_ <= kRoutePlaces, field, "must be at most " + std::to_string(kRoutePlaces));
    return value_;
  };
  value.at = index("passed", wire.passed());
  value.freed = index("freed", wire.freed());
  value.released = index("released", wire.released());
  value.goal_from_robot = from_idl(wire.goal_from_robot(), reading.in("goal_from_robot"));
  value.reason = reading.text("reason", wire.reason(), kTextLength);
  return reading.finish(std::move(value));
}

idl::AgentCommand to_idl(const msg::AgentCommand& message) {
  idl::AgentCommand wire;
  wire.header(to_idl(message.header));
  wire.to(message.to.bytes);
  wire.command(message.command);
  wire.kind(static_cast<std::uint8_t>(message.kind));
  wire.name(message.name);
  wire.has_seed(message.seed.has_value());
  wire.seed(to_idl(message.seed.value_or(PlaceId{})));
  wire.along(to_idl(message.along));
  return wire;
}

Result<msg::AgentCommand> from_idl(const idl::AgentCommand& wire) {
  using Kind = msg::AgentCommand::Kind;
  Reading reading("AgentCommand");
  msg::AgentCommand value;
  value.header = from_idl(wire.header(), reading.in("header"));
  value.to = reading.some("to", id_from<PeerId>(wire.to()));
  value.command = wire.command();
  value.kind = reading.choice("kind", wire.kind(), Kind::teach_start, Kind::counts);
  value.name = reading.text("name", wire.name(), kNameLength);
  if (wire.has_seed()) value.seed = reading.some("seed", from_idl(wire.seed()));
  value.along = from_idl(wire.along(), reading.in("along"));
  return reading.finish(std::move(value));
}

idl::AgentReply to_idl(const msg::AgentReply& message) {
  idl::AgentReply wire;
  wire.header(to_idl(message.header));
  wire.command(message.command);
  wire.done(message.done);
  wire.reason(message.reason);
  wire.place(to_idl(message.place));
  wire.experience(message.experience.value);
  wire.report(list_to_idl<idl::TaughtStretch>(message.report));
  wire.counts(counts_to_idl(message.counts));
  return wire;
}

Result<msg::AgentReply> from_idl(const idl::AgentReply& wire) {
  Reading reading("AgentReply");
  msg::AgentReply value;
  value.header = from_idl(wire.header(), reading.in("header"));
  value.command = wire.command();
  value.done = wire.done();
  value.reason = reading.text("reason", wire.reason(), kTextLength);
  value.place = from_idl(wire.place());
  value.experience = ExperienceId{wire.experience()};
  value.report = list_from_idl<msg::TaughtStretch>(wire.report(), reading, "report", msg::kReportRows);
  value.counts = counts_from_idl(wire.counts(), reading, "counts");
  return reading.finish(std::move(value));
}

}  // namespace weft::convert
