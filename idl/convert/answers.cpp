#include "idl/convert/common.hpp"
#include "idl/convert/limits.hpp"
#include "idl/convert/session.hpp"

namespace weft::convert {

static idl::GoalEvent goal_event_to_idl(const GoalEvent& event) {
  idl::GoalEvent wire;
  wire.at_ns(nanoseconds(event.at));
  wire.state(static_cast<std::uint8_t>(event.state));
  wire.cause(event.cause);
  wire.who(event.who);
  return wire;
}

static GoalEvent from_idl(const idl::GoalEvent& wire, Reading reading) {
  GoalEvent value;
  value.at = wall_from(wire.at_ns());
  value.state = reading.choice("state", wire.state(), GoalState::pending, GoalState::rejected);
  value.cause = reading.text("cause", wire.cause(), kTextLength);
  value.who = reading.text("who", wire.who(), kNameLength);
  return value;
}

static idl::Goal goal_to_idl(const Goal& goal) {
  idl::Goal wire;
  wire.id(goal.id.bytes);
  wire.label(goal.label);
  wire.destination(to_idl(goal.to));
  wire.has_wanted(goal.wanted.has_value());
  wire.wanted(goal.wanted.value_or(RobotId{}).bytes);
  wire.has_robot(goal.robot.has_value());
  wire.robot(goal.robot.value_or(RobotId{}).bytes);
  wire.state(static_cast<std::uint8_t>(goal.state));
  wire.number(goal.number);
  wire.has_route(goal.route.has_value());
  wire.route(goal.route.value_or(RouteId{}).bytes);
  wire.route_version(goal.route_version);
  for (const GoalEvent& event : goal.history) wire.history().push_back(goal_event_to_idl(event));
  return wire;
}

static Goal from_idl(const idl::Goal& wire, Reading reading) {
  Goal value;
  value.id = reading.some("id", id_from<GoalId>(wire.id()));
  value.label = reading.text("label", wire.label(), kNameLength);
  value.to = from_idl(wire.destination());
  if (wire.has_wanted()) value.wanted = reading.some("wanted", id_from<RobotId>(wire.wanted()));
  if (wire.has_robot()) value.robot = reading.some("robot", id_from<RobotId>(wire.robot()));
  value.state = reading.choice("state", wire.state(), GoalState::pending, GoalState::rejected);
  value.number = wire.number();
  if (wire.has_route()) value.route = reading.some("route", id_from<RouteId>(wire.route()));
  value.route_version = wire.route_version();
  value.history = list_from_idl<GoalEvent>(wire.history(), reading, "history", kHistory);
  return value;
}

static idl::Event event_to_idl(const msg::Event& event) {
  idl::Event wire;
  wire.at_ns(nanoseconds(event.at));
  wire.kind(event.kind);
  wire.robot(event.robot.bytes);
  wire.goal(event.goal.bytes);
  wire.cause(event.cause);
  wire.who(event.who);
  return wire;
}

static msg::Event from_idl(const idl::Event& wire, Reading reading) {
  msg::Event value;
  value.at = wall_from(wire.at_ns());
  value.kind = reading.text("kind", wire.kind(), kNameLength);
  value.robot = id_from<RobotId>(wire.robot());
  value.goal = id_from<GoalId>(wire.goal());
  value.cause = reading.text("cause", wire.cause(), kTextLength);
  value.who = reading.text("who", wire.who(), kNameLength);
  return value;
}

static idl::RevisionNote note_to_idl(const msg::RevisionNote& note) {
  idl::RevisionNote wire;
  wire.revision(note.revision.value);
  wire.base(note.base.value);
  wire.at_ns(nanoseconds(note.at));
  wire.kind(note.kind);
  wire.who(note.who);
  wire.cause(note.cause);
  return wire;
}

static msg::RevisionNote from_idl(const idl::RevisionNote& wire, Reading reading) {
  msg::RevisionNote value;
  value.revision = Revision{wire.revision()};
  value.base = Revision{wire.base()};
  reading.require(value.base < value.revision, "base", "must be before the revision");
  value.at = wall_from(wire.at_ns());
  value.kind = reading.text("kind", wire.kind(), kNameLength);
  value.who = reading.text("who", wire.who(), kNameLength);
  value.cause = reading.text("cause", wire.cause(), kTextLength);
  return value;
}

static idl::RobotRow row_to_idl(const msg::RobotRow& row) {
  idl::RobotRow wire;
  wire.has_description(bool(row.description.header.sender));
  wire.description(to_idl(row.description));
  wire.has_state(bool(row.state.header.sender));
  wire.state(to_idl(row.state));
  wire.silent_s(row.silent_s);
  wire.is_heard(row.is_heard);
  wire.vendor(row.vendor);
  wire.software(row.software);
  wire.clock_skew_s(row.clock_skew_s);
  wire.occupies(row.occupies);
  wire.window_bytes(row.window_bytes);
  wire.content_bytes(row.content_bytes);
  return wire;
}

static msg::RobotRow from_idl(const idl::RobotRow& wire, Reading reading) {
  msg::RobotRow value;
  if (wire.has_description()) value.description = from_idl(wire.description(), reading.in("description"));
  if (wire.has_state()) value.state = from_idl(wire.state(), reading.in("state"));
  value.silent_s = reading.not_negative("silent_s", wire.silent_s());
  value.is_heard = wire.is_heard();
  value.vendor = reading.text("vendor", wire.vendor(), kNameLength);
  value.software = reading.text("software", wire.software(), kNameLength);
  value.clock_skew_s = reading.finite("clock_skew_s", wire.clock_skew_s());
  value.occupies = reading.text("occupies", wire.occupies(), kTextLength);
  value.window_bytes = wire.window_bytes();
  value.content_bytes = wire.content_bytes();
  return value;
}

static idl::ExperienceRow row_to_idl(const msg::ExperienceRow& row) {
  idl::ExperienceRow wire;
  wire.id(row.id.value);
  wire.name(row.name);
  wire.robot(row.robot.bytes);
  wire.method(row.method);
  wire.sealed(row.sealed);
  wire.places(row.places);
  wire.metres(row.metres);
  wire.begun_ns(nanoseconds(row.begun));
  wire.labels(row.labels);
  for (const ExperienceId& id : row.joined) wire.joined().push_back(id.value);
  wire.joined_count(row.joined_count);
  return wire;
}

static msg::ExperienceRow from_idl(const idl::ExperienceRow& wire, Reading reading) {
  msg::ExperienceRow value;
  value.id = reading.some("id", ExperienceId{wire.id()});
  value.name = reading.text("name", wire.name(), kNameLength);
  value.robot = id_from<RobotId>(wire.robot());
  value.method = reading.text("method", wire.method(), kNameLength);
  value.sealed = wire.sealed();
  value.places = wire.places();
  value.metres = reading.not_negative("metres", wire.metres());
  value.begun = wall_from(wire.begun_ns());
  for (const std::string& label : reading.list("labels", wire.labels(), msg::kPatchEntities)) {
    value.labels.push_back(reading.text("labels", label, kNameLength));
  }
  for (const std::uint64_t id : reading.list("joined", wire.joined(), msg::kJoinedTold)) {
    value.joined.push_back(ExperienceId{id});
  }
  value.joined_count = wire.joined_count();
  return value;
}

static idl::MapInfo info_to_idl(const msg::MapInfo& info) {
  idl::MapInfo wire;
  wire.revision(info.revision.value);
  wire.epoch(info.epoch.value);
  wire.experiences(info.experiences);
  wire.places(info.places);
  wire.stitches(info.stitches);
  wire.contents(info.contents);
  wire.content_bytes(info.content_bytes);
  wire.batches_acknowledged(info.batches_acknowledged);
  wire.batches_refused(info.batches_refused);
  wire.disk_free_bytes(info.disk_free_bytes);
  wire.software(info.software);
  wire.vendor(info.vendor);
  wire.engine(info.engine);
  wire.stopped(info.stopped);
  wire.unjoined(info.unjoined);
  wire.counters(counts_to_idl(info.counters));
  return wire;
}

static msg::MapInfo from_idl(const idl::MapInfo& wire, Reading reading) {
  msg::MapInfo value;
  value.revision = Revision{wire.revision()};
  value.epoch = Epoch{wire.epoch()};
  value.experiences = wire.experiences();
  value.places = wire.places();
  value.stitches = wire.stitches();
  value.contents = wire.contents();
  value.content_bytes = wire.content_bytes();
  value.batches_acknowledged = wire.batches_acknowledged();
  value.batches_refused = wire.batches_refused();
  value.disk_free_bytes = wire.disk_free_bytes();
  value.software = reading.text("software", wire.software(), kNameLength);
  value.vendor = reading.text("vendor", wire.vendor(), kNameLength);
  value.engine = reading.text("engine", wire.engine(), kNameLength);
  value.stopped = reading.text("stopped", wire.stopped(), kTextLength);
  value.unjoined = reading.text("unjoined", wire.unjoined(), kTextLength);
  value.counters = counts_from_idl(wire.counters(), reading, "counters");
  return value;
}

static idl::NetworkPage page_to_idl(const NetworkPage& page) {
  idl::NetworkPage wire;
  wire.revision(page.revision.value);
  wire.places(list_to_idl<idl::Place>(page.places));
  wire.edges(list_to_idl<idl::Edge>(page.edges));
  wire.labels(labels_to_idl(page.labels));
  wire.aparts(list_to_idl<idl::Apart>(page.aparts));
  wire.total(page.total);
  wire.is_last(page.is_last);
  return wire;
}

static NetworkPage from_idl(const idl::NetworkPage& wire, Reading reading) {
  NetworkPage value;
  value.revision = Revision{wire.revision()};
  reading.require(
      wire.places().size() + wire.edges().size() + wire.labels().size() + wire.aparts().size() <= msg::kPatchEntities,
      "places, edges, labels and aparts", "must be at most " + std::to_string(msg::kPatchEntities) + " together");
  value.places = list_from_idl<Place>(wire.places(), reading, "places", msg::kPatchEntities);
  value.edges = list_from_idl<Edge>(wire.edges(), reading, "edges", msg::kPatchEntities);
  value.labels = labels_from_idl(reading.list("labels", wire.labels(), msg::kPatchEntities), reading.in("labels"));
  value.aparts = list_from_idl<Apart>(wire.aparts(), reading, "aparts", msg::kPatchEntities);
  value.total = wire.total();
  value.is_last = wire.is_last();
  return value;
}

idl::QueryReply to_idl(const msg::QueryReply& message) {
  idl::QueryReply wire;
  wire.header(to_idl(message.header));
  wire.to(message.to.bytes);
  wire.request(message.request);
  wire.part(message.part);
  wire.parts(message.parts);
  for (const msg::RobotRow& row : message.robots) wire.robots().push_back(row_to_idl(row));
  for (const Goal& goal : message.goals) wire.goals().push_back(goal_to_idl(goal));
  wire.routes(list_to_idl<idl::Route>(message.routes));
  for (const msg::Event& event : message.events) wire.events().push_back(event_to_idl(event));
  wire.info(info_to_idl(message.info));
  for (const msg::RevisionNote& note : message.log) wire.log().push_back(note_to_idl(note));
  wire.network(page_to_idl(message.network));
  for (const msg::ExperienceRow& row : message.experiences) wire.experiences().push_back(row_to_idl(row));
  wire.outcome(static_cast<std::uint8_t>(message.outcome));
  wire.message(message.message);
  return wire;
}

Result<msg::QueryReply> from_idl(const idl::QueryReply& wire) {
  Reading reading("QueryReply");
  msg::QueryReply value;
  value.header = from_idl(wire.header(), reading.in("header"));
  value.to = reading.some("to", id_from<PeerId>(wire.to()));
  value.request = wire.request();
  value.part = wire.part();
  value.parts = wire.parts();
  reading.require(value.parts >= 1 && value.parts <= kParts, "parts", "must be from 1 to " + std::to_string(kParts));
  reading.require(value.part < value.parts, "part", "must be below parts");
  value.robots = list_from_idl<msg::RobotRow>(wire.robots(), reading, "robots", kRows);
  value.goals = list_from_idl<Goal>(wire.goals(), reading, "goals", kRows);
  value.routes = list_from_idl<Route>(wire.routes(), reading, "routes", kRows);
  value.events = list_from_idl<msg::Event>(wire.events(), reading, "events", kEvents);
  value.info = from_idl(wire.info(), reading.in("info"));
  value.log = list_from_idl<msg::RevisionNote>(wire.log(), reading, "log", kRows);
  value.network = from_idl(wire.network(), reading.in("network"));
  value.experiences = list_from_idl<msg::ExperienceRow>(wire.experiences(), reading, "experiences", kRows);
  value.outcome = reading.choice("outcome", wire.outcome(), msg::Outcome::done, msg::Outcome::failed);
  value.message = reading.text("message", wire.message(), kTextLength);
  return reading.finish(std::move(value));
}

idl::EventNote to_idl(const msg::EventNote& message) {
  idl::EventNote wire;
  wire.header(to_idl(message.header));
  wire.event(event_to_idl(message.event));
  return wire;
}

Result<msg::EventNote> from_idl(const idl::EventNote& wire) {
  Reading reading("EventNote");
  msg::EventNote value;
  value.header = from_idl(wire.header(), reading.in("header"));
  value.event = from_idl(wire.event(), reading.in("event"));
  return reading.finish(std::move(value));
}

}  // namespace weft::convert
