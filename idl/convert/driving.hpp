#pragma once
#include "idl/convert/common.hpp"
#include "wire/driving.h"

namespace weft::convert {

template <class Io>
void describe(Io& io, Value<Io, msg::RouteOrder>& value, Wire<Io, idl::RouteOrder>& wire) {
  io.in("header", value.header, wire.header());
  io.some("to", value.to, wire.to());
  io.in("route", value.route, wire.route());
}

template <class Io>
void describe(Io& io, Value<Io, msg::RouteProgress>& value, Wire<Io, idl::RouteProgress>& wire) {
  io.in("header", value.header, wire.header());
  io.any(value.goal, wire.goal());
  io.some("route", value.route, wire.route());
  io.any(value.version, wire.version());
  io.choice("phase", value.phase, wire.phase(), msg::RoutePhase::accepted, msg::RoutePhase::failed);
  io.at_most("passed", value.at, wire.passed(), kRoutePlaces);
  io.at_most("freed", value.freed, wire.freed(), kRoutePlaces);
  io.at_most("released", value.released, wire.released(), kRoutePlaces);
  io.in("goal_from_robot", value.goal_from_robot, wire.goal_from_robot());
  io.text("reason", value.reason, wire.reason(), kTextLength);
}

template <class Io>
void describe(Io& io, Value<Io, msg::AgentCommand>& value, Wire<Io, idl::AgentCommand>& wire) {
  using Kind = msg::AgentCommand::Kind;
  io.in("header", value.header, wire.header());
  io.some("to", value.to, wire.to());
  io.any(value.command, wire.command());
  io.choice("kind", value.kind, wire.kind(), Kind::teach_start, Kind::counts);
  io.text("name", value.name, wire.name(), kNameLength);
  io.maybe("seed", value.seed, wire.has_seed(), wire.seed());
  io.in("along", value.along, wire.along());
}

template <class Io>
void describe(Io& io, Value<Io, msg::AgentReply>& value, Wire<Io, idl::AgentReply>& wire) {
  io.in("header", value.header, wire.header());
  io.any(value.command, wire.command());
  io.any(value.done, wire.done());
  io.text("reason", value.reason, wire.reason(), kTextLength);
  io.any(value.place, wire.place());
  io.any(value.experience, wire.experience());
  io.each("report", value.report, wire.report(), msg::kReportRows);
  counts(io, "counts", value.counts, wire.counts());
}

}  // namespace weft::convert
