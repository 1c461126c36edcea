#pragma once
#include "idl/convert/session.hpp"
#include "wire/operating.h"

/// Converts answers to queries, and events.
namespace weft::convert {

template <class Io>
void describe(Io& io, Value<Io, GoalEvent>& value, Wire<Io, idl::GoalEvent>& wire) {
  io.any(value.at, wire.at_ns());
  io.choice("state", value.state, wire.state(), GoalState::pending, GoalState::rejected);
  io.text("cause", value.cause, wire.cause(), kTextLength);
  io.text("who", value.who, wire.who(), kNameLength);
}

template <class Io>
void describe(Io& io, Value<Io, Goal>& value, Wire<Io, idl::Goal>& wire) {
  io.some("id", value.id, wire.id());
  io.text("label", value.label, wire.label(), kNameLength);
  io.any(value.to, wire.destination());
  io.maybe("wanted", value.wanted, wire.has_wanted(), wire.wanted());
  io.maybe("robot", value.robot, wire.has_robot(), wire.robot());
  io.choice("state", value.state, wire.state(), GoalState::pending, GoalState::rejected);
  io.any(value.number, wire.number());
  io.maybe("route", value.route, wire.has_route(), wire.route());
  io.any(value.route_version, wire.route_version());
  io.at_most("priority", value.priority, wire.priority(), kHighestPriority);
  io.choice("kind", value.kind, wire.kind(), GoalKind::operator_asked, GoalKind::park);
  io.any(value.no_return, wire.no_return());
  io.each("history", value.history, wire.history(), kHistory);
}

template <class Io>
void describe(Io& io, Value<Io, msg::Event>& value, Wire<Io, idl::Event>& wire) {
  io.any(value.at, wire.at_ns());
  io.text("kind", value.kind, wire.kind(), kNameLength);
  io.any(value.robot, wire.robot());
  io.any(value.goal, wire.goal());
  io.text("cause", value.cause, wire.cause(), kTextLength);
  io.text("who", value.who, wire.who(), kNameLength);
  io.any(value.number, wire.number());
}

template <class Io>
void describe(Io& io, Value<Io, msg::Alarm>& value, Wire<Io, idl::Alarm>& wire) {
  io.choice("kind", value.kind, wire.kind(), msg::AlarmKind::silent, msg::AlarmKind::unjoined);
  io.any(value.robot, wire.robot());
  io.text("about", value.about, wire.about(), kNameLength);
  io.any(value.place, wire.place());
  io.any(value.since, wire.since_ns());
  io.text("detail", value.detail, wire.detail(), kTextLength);
}

template <class Io>
void describe(Io& io, Value<Io, msg::RevisionNote>& value, Wire<Io, idl::RevisionNote>& wire) {
  io.any(value.revision, wire.revision());
  io.any(value.base, wire.base());
  io.require(value.base < value.revision, "base", "must be before the revision");
  io.any(value.at, wire.at_ns());
  io.text("kind", value.kind, wire.kind(), kNameLength);
  io.text("who", value.who, wire.who(), kNameLength);
  io.text("cause", value.cause, wire.cause(), kTextLength);
}

template <class Io>
void describe(Io& io, Value<Io, msg::RobotWait>& value, Wire<Io, idl::RobotWait>& wire) {
  io.any(value.at, wire.at());
  io.any(value.needs, wire.needs());
  const std::size_t holders = io.entries("held_by", value.held_by, wire.held_by(), msg::kHoldersTold);
  for (std::size_t i = 0; i < holders; ++i) io.some("held_by", value.held_by[i], wire.held_by()[i].robot());
  io.any(value.since, wire.since_ns());
  io.text("rule", value.rule, wire.rule(), kNameLength);
}

template <class Io>
void describe(Io& io, Value<Io, msg::RobotRow>& value, Wire<Io, idl::RobotRow>& wire) {
  if (io.is_there(bool(value.description.header.sender), wire.has_description())) {
    io.in("description", value.description, wire.description());
  }
  if (io.is_there(bool(value.state.header.sender), wire.has_state())) io.in("state", value.state, wire.state());
  io.not_negative("silent_s", value.silent_s, wire.silent_s());
  io.any(value.is_heard, wire.is_heard());
  io.text("vendor", value.vendor, wire.vendor(), kNameLength);
  io.text("software", value.software, wire.software(), kNameLength);
  io.finite("clock_skew_s", value.clock_skew_s, wire.clock_skew_s());
  io.text("occupies", value.occupies, wire.occupies(), kTextLength);
  io.any(value.window_bytes, wire.window_bytes());
  io.any(value.content_bytes, wire.content_bytes());
  io.any(value.messages_heard, wire.messages_heard());
  io.any(value.messages_missed, wire.messages_missed());
  io.in("wait", value.wait, wire.wait());
  io.text("standstill", value.standstill, wire.standstill(), kTextLength);
  if (io.is_there(bool(value.power.header.sender), wire.has_power())) io.in("power", value.power, wire.power());
  io.text("held_by", value.held_by, wire.held_by(), kNameLength);
  io.text("plan", value.plan, wire.plan(), kNameLength);
  io.finite("plan_x_m", value.plan_from_robot.x, wire.plan_x_m());
  io.finite("plan_y_m", value.plan_from_robot.y, wire.plan_y_m());
  io.finite("plan_heading_rad", value.plan_from_robot.heading, wire.plan_heading_rad());
  io.any(value.is_twin, wire.is_twin());
  io.any(value.is_deaf, wire.is_deaf());
  io.any(value.is_window_current, wire.is_window_current());
}

template <class Io>
void describe(Io& io, Value<Io, msg::ExperienceRow>& value, Wire<Io, idl::ExperienceRow>& wire) {
  io.some("id", value.id, wire.id());
  io.text("name", value.name, wire.name(), kNameLength);
  io.any(value.robot, wire.robot());
  io.text("method", value.method, wire.method(), kNameLength);
  io.any(value.sealed, wire.sealed());
  io.any(value.places, wire.places());
  io.not_negative("metres", value.metres, wire.metres());
  io.any(value.begun, wire.begun_ns());
  io.texts("labels", value.labels, wire.labels(), msg::kPatchEntities, kNameLength);
  io.texts("leads_nowhere", value.leads_nowhere, wire.leads_nowhere(), msg::kPatchEntities, kNameLength);
  const std::size_t joined = io.entries("joined", value.joined, wire.joined(), msg::kJoinedTold);
  for (std::size_t i = 0; i < joined; ++i) io.any(value.joined[i], wire.joined()[i]);
  io.any(value.joined_count, wire.joined_count());
}

template <class Io>
void describe(Io& io, Value<Io, msg::AwaitedLabelRow>& value, Wire<Io, idl::AwaitedLabelRow>& wire) {
  io.text("label", value.label, wire.label(), kNameLength);
  io.in("place", value.place, wire.place());
  io.some("robot", value.robot, wire.robot());
  io.text("who", value.who, wire.who(), kNameLength);
}

template <class Io>
void describe(Io& io, Value<Io, msg::MapInfo>& value, Wire<Io, idl::MapInfo>& wire) {
  io.any(value.revision, wire.revision());
  io.any(value.epoch, wire.epoch());
  io.any(value.experiences, wire.experiences());
  io.any(value.places, wire.places());
  io.any(value.stitches, wire.stitches());
  io.any(value.contents, wire.contents());
  io.any(value.content_bytes, wire.content_bytes());
  io.any(value.batches_acknowledged, wire.batches_acknowledged());
  io.any(value.batches_refused, wire.batches_refused());
  io.any(value.disk_free_bytes, wire.disk_free_bytes());
  io.text("software", value.software, wire.software(), kNameLength);
  io.text("vendor", value.vendor, wire.vendor(), kNameLength);
  io.text("engine", value.engine, wire.engine(), kNameLength);
  io.text("stopped", value.stopped, wire.stopped(), kTextLength);
  io.text("unjoined", value.unjoined, wire.unjoined(), kTextLength);
  counts(io, "counters", value.counters, wire.counters());
}

template <class Io>
void describe(Io& io, Value<Io, NetworkPage>& value, Wire<Io, idl::NetworkPage>& wire) {
  io.any(value.revision, wire.revision());
  io.require_at_most(wire.places().size() + wire.edges().size() + wire.labels().size() + wire.aparts().size() +
                         wire.rules().size() + wire.registrations().size(),
                     msg::kPatchEntities, "places, edges, labels, aparts, rules and registrations", " together");
  io.each("places", value.places, wire.places(), msg::kPatchEntities);
  io.each("edges", value.edges, wire.edges(), msg::kPatchEntities);
  labels(io, value.labels, wire.labels(), msg::kPatchEntities);
  io.each("aparts", value.aparts, wire.aparts(), msg::kPatchEntities);
  io.each("rules", value.rules, wire.rules(), msg::kPatchEntities);
  io.each("registrations", value.registrations, wire.registrations(), kMostRegistrations);
  io.any(value.total, wire.total());
  io.any(value.is_last, wire.is_last());
}

template <class Io>
void describe(Io& io, Value<Io, msg::RuleRow>& value, Wire<Io, idl::RuleRow>& wire) {
  io.in("rule", value.rule, wire.rule());
  io.any(value.places, wire.places());
  io.text("problem", value.problem, wire.problem(), kTextLength);
}

template <class Io>
void describe(Io& io, Value<Io, msg::RegistrationRow::PickRow>& value, Wire<Io, idl::PickRow>& wire) {
  using State = msg::RegistrationRow::PickState;
  io.choice("state", value.state, wire.state(), State::counts, State::gone);
  io.not_negative("off_m", value.off_m, wire.off_m());
}

template <class Io>
void describe(Io& io, Value<Io, msg::RegistrationRow>& value, Wire<Io, idl::RegistrationRow>& wire) {
  io.in("registration", value.registration, wire.registration());
  io.each("picks", value.picks, wire.picks(), kMostPicks);
  io.any(value.places, wire.places());
  io.any(value.all_places, wire.all_places());
  io.not_negative("scale", value.scale, wire.scale());
  io.not_negative("sigma_m", value.sigma_m, wire.sigma_m());
  io.text("text", value.text, wire.text(), kTextLength);
  io.text("problem", value.problem, wire.problem(), kTextLength);
}

template <class Io>
void describe(Io& io, Value<Io, msg::Arrival>& value, Wire<Io, idl::Arrival>& wire) {
  io.some("goal", value.goal, wire.goal());
  io.not_negative("in_s", value.in_s, wire.in_s());
  io.not_negative("soonest_s", value.soonest_s, wire.soonest_s());
  io.not_negative("latest_s", value.latest_s, wire.latest_s());
}

template <class Io>
void describe(Io& io, Value<Io, msg::QueryReply>& value, Wire<Io, idl::QueryReply>& wire) {
  io.in("header", value.header, wire.header());
  io.some("to", value.to, wire.to());
  io.any(value.request, wire.request());
  part_of(io, value, wire);
  io.each("robots", value.robots, wire.robots(), kRows);
  io.each("goals", value.goals, wire.goals(), kRows);
  io.each("routes", value.routes, wire.routes(), kRows);
  io.each("arrivals", value.arrivals, wire.arrivals(), kRows);
  io.each("events", value.events, wire.events(), kEvents);
  io.any(value.oldest_event, wire.oldest_event());
  io.any(value.newest_event, wire.newest_event());
  io.each("alarms", value.alarms, wire.alarms(), kRows);
  io.in("info", value.info, wire.info());
  io.each("log", value.log, wire.log(), kRows);
  io.in("network", value.network, wire.network());
  io.each("experiences", value.experiences, wire.experiences(), kRows);
  io.each("awaited_labels", value.awaited_labels, wire.awaited_labels(), kRows);
  io.each("rules", value.rules, wire.rules(), kRows);
  io.each("registrations", value.registrations, wire.registrations(), kMostRegistrations);
  io.choice("outcome", value.outcome, wire.outcome(), msg::Outcome::done, msg::Outcome::failed);
  io.text("message", value.message, wire.message(), kTextLength);
}

template <class Io>
void describe(Io& io, Value<Io, msg::EventNote>& value, Wire<Io, idl::EventNote>& wire) {
  io.in("header", value.header, wire.header());
  io.in("event", value.event, wire.event());
  io.any(value.is_kept, wire.is_kept());
}

}  // namespace weft::convert
