#pragma once
#include "idl/convert/common.hpp"
#include "wire/operating.h"

/// Converts operators' requests and the answers to them: their visitors.
namespace weft::convert {

template <class Io>
void describe(Io& io, Value<Io, msg::MapWork>& value, Wire<Io, idl::MapWork>& wire) {
  io.any(value.revision, wire.revision());
  io.each("places", value.what.places, wire.places(), kRemoved);
  io.each("stitches", value.what.stitches, wire.stitches(), kRemoved);
  io.any(value.only_say, wire.only_say());
  io.not_negative("within_m", value.within_m, wire.within_m());
  io.require(value.within_m <= kWithin_m, "within_m", "must be at most 10");
  io.not_negative("within_rad", value.within_rad, wire.within_rad());
  io.require(value.within_rad <= kWithin_rad, "within_rad", "must be at most pi");
  io.text("file", value.file, wire.file(), kFileLength);
}

template <class Io>
void describe(Io& io, Value<Io, msg::PointOnPlan>& value, Wire<Io, idl::PointOnPlan>& wire) {
  io.text("plan", value.plan, wire.plan(), kNameLength);
  point(io, "point", value.point, wire.x_m(), wire.y_m());
}

template <class Io>
void describe(Io& io, Value<Io, msg::OperatorRequest>& value, Wire<Io, idl::OperatorRequest>& wire) {
  using Kind = msg::OperatorRequest::Kind;
  io.in("header", value.header, wire.header());
  io.any(value.request, wire.request());
  io.choice("kind", value.kind, wire.kind(), Kind::goal_send, Kind::plan_remove);
  io.text("who", value.who, wire.who(), kNameLength);
  io.text("robot", value.robot, wire.robot(), kNameLength);
  io.text("label", value.label, wire.label(), kNameLength);
  io.text("new_label", value.new_label, wire.new_label(), kNameLength);
  io.any(value.place, wire.place());
  io.any(value.goal, wire.goal());
  const bool needs_goal =
      value.kind == Kind::goal_send || value.kind == Kind::goal_cancel || value.kind == Kind::goal_hand_over;
  io.require(!needs_goal || value.goal, "goal", "must not be none");
  io.in("along", value.along, wire.along());
  io.in("work", value.work, wire.work());
  io.any(value.is_sure, wire.is_sure());
  io.in("rule", value.rule, wire.rule());
  io.at_most("priority", value.priority, wire.priority(), kHighestPriority);
  io.any(value.no_return, wire.no_return());
  io.in("registration", value.registration, wire.registration());
  if (io.is_there(value.on_plan.has_value(), wire.has_on_plan())) {
    if constexpr (Io::kReads) {
      io.in("on_plan", value.on_plan.emplace(), wire.on_plan());
    } else {
      io.in("on_plan", value.on_plan.value_or(msg::PointOnPlan{}), wire.on_plan());
    }
  }
}

template <class Io>
void describe(Io& io, Value<Io, msg::OperatorReply>& value, Wire<Io, idl::OperatorReply>& wire) {
  io.in("header", value.header, wire.header());
  io.some("to", value.to, wire.to());
  io.any(value.request, wire.request());
  io.choice("outcome", value.outcome, wire.outcome(), msg::Outcome::done, msg::Outcome::under_way);
  io.text("message", value.message, wire.message(), kTextLength);
  io.any(value.goal, wire.goal());
  io.any(value.place, wire.place());
  io.any(value.experience, wire.experience());
  io.any(value.revision, wire.revision());
  io.any(value.done, wire.done());
  io.any(value.total, wire.total());
  io.text("unit", value.unit, wire.unit(), kNameLength);
  io.texts("findings", value.findings, wire.findings(), kFindings, kTextLength);
  counts(io, "counts", value.counts, wire.counts());
  io.each("report", value.report, wire.report(), msg::kReportRows);
}

template <class Io>
void describe(Io& io, Value<Io, msg::Query>& value, Wire<Io, idl::Query>& wire) {
  using Kind = msg::Query::Kind;
  io.in("header", value.header, wire.header());
  io.any(value.request, wire.request());
  io.choice("kind", value.kind, wire.kind(), Kind::robots, Kind::alarms);
  io.any(value.goal, wire.goal());
  io.text("robot", value.robot, wire.robot(), kNameLength);
  io.any(value.newest, wire.newest());
  io.any(value.most, wire.most());
  io.any(value.at, wire.at_revision());
  io.any(value.apart_from, wire.apart_from());
  io.any(value.after, wire.after());
  io.text("event_kind", value.event_kind, wire.event_kind(), kNameLength);
  io.any(value.since, wire.since_ns());
  io.any(value.after_event, wire.after_event());
}

}  // namespace weft::convert
