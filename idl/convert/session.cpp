#include "idl/convert/session.hpp"

#include "idl/convert/common.hpp"
#include "idl/convert/limits.hpp"

namespace weft::convert {

static idl::Camera camera_to_idl(const msg::Camera& camera) {
  idl::Camera wire;
  wire.id(camera.id);
  wire.width(camera.width);
  wire.height(camera.height);
  wire.calibration(camera.calibration);
  return wire;
}

static msg::Camera from_idl(const idl::Camera& wire, Reading reading) {
  return {reading.text("id", wire.id(), kNameLength), wire.width(), wire.height(),
          reading.text("calibration", wire.calibration(), kCalibrationLength)};
}

idl::Hello to_idl(const msg::Hello& message) {
  idl::Hello wire;
  wire.peer(message.peer.bytes);
  wire.incarnation(message.incarnation);
  wire.role(static_cast<std::uint8_t>(message.role));
  wire.protocol_min(message.protocol_min);
  wire.protocol_max(message.protocol_max);
  wire.epoch(message.epoch.value);
  wire.name(message.name);
  wire.software(message.software);
  wire.vendor(message.vendor);
  wire.challenge(message.challenge);
  wire.answers(message.answers);
  return wire;
}

Result<msg::Hello> from_idl(const idl::Hello& wire) {
  Reading reading("Hello");
  msg::Hello value;
  value.peer = reading.some("peer", id_from<PeerId>(wire.peer()));
  value.incarnation = wire.incarnation();
  value.role = reading.choice("role", wire.role(), msg::Role::server, msg::Role::client);
  value.protocol_min = wire.protocol_min();
  value.protocol_max = wire.protocol_max();
  reading.require(value.protocol_min <= value.protocol_max, "protocol_max", "must be at least protocol_min");
  value.epoch = Epoch{wire.epoch()};
  value.name = reading.text("name", wire.name(), kNameLength);
  value.software = reading.text("software", wire.software(), kNameLength);
  value.vendor = reading.text("vendor", wire.vendor(), kNameLength);
  value.challenge = wire.challenge();
  value.answers = reading.list("answers", wire.answers(), msg::kAnswers);
  return reading.finish(std::move(value));
}

idl::RobotDescription to_idl(const msg::RobotDescription& message) {
  idl::RobotDescription wire;
  wire.robot(message.header.sender.bytes);
  wire.header(to_idl(message.header));
  wire.name(message.name);
  wire.body(message.body);
  wire.methods(message.methods);
  wire.footprint_radius_m(message.footprint_radius_m);
  wire.can_be_taught_along(message.can_be_taught_along);
  for (const msg::Camera& camera : message.cameras) wire.cameras().push_back(camera_to_idl(camera));
  return wire;
}

msg::RobotDescription from_idl(const idl::RobotDescription& wire, Reading reading) {
  msg::RobotDescription value;
  value.header = from_idl(wire.header(), reading.in("header"));
  reading.require(wire.robot() == value.header.sender.bytes, "robot", "must be the sender");
  value.name = reading.text("name", wire.name(), kNameLength);
  value.body = reading.text("body", wire.body(), kNameLength);
  value.methods = reading.list("methods", wire.methods(), kMethods);
  for (const std::string& method : value.methods) reading.text("methods", method, kNameLength);
  value.footprint_radius_m = reading.finite("footprint_radius_m", wire.footprint_radius_m());
  reading.require(value.footprint_radius_m > 0.0 && value.footprint_radius_m <= 5.0, "footprint_radius_m",
                  "must be above 0 and at most 5");
  value.can_be_taught_along = wire.can_be_taught_along();
  value.cameras = list_from_idl<msg::Camera>(wire.cameras(), reading, "cameras", kCameras);
  return value;
}

Result<msg::RobotDescription> from_idl(const idl::RobotDescription& wire) {
  Reading reading("RobotDescription");
  auto value = from_idl(wire, reading.here());
  return reading.finish(std::move(value));
}

idl::RobotState to_idl(const msg::RobotState& message) {
  idl::RobotState wire;
  wire.robot(message.header.sender.bytes);
  wire.header(to_idl(message.header));
  wire.name(message.name);
  wire.mode(static_cast<std::uint8_t>(message.mode));
  wire.localised(message.localised);
  wire.place(to_idl(message.place));
  wire.place_from_robot(to_idl(message.place_from_robot));
  wire.blind_m(message.blind_m);
  wire.speed_m_s(message.speed_m_s);
  wire.frame(message.frame);
  wire.experience(message.experience.value);
  wire.goal(message.goal.bytes);
  wire.route(message.route.bytes);
  wire.route_version(message.route_version);
  wire.window_revision(message.window_revision.value);
  wire.window_digest(message.window_digest.bytes);
  wire.contents_missing(message.contents_missing);
  wire.memory_bytes(message.memory_bytes);
  wire.memory_cap_bytes(message.memory_cap_bytes);
  wire.diagnostics(list_to_idl<idl::Diagnostic>(message.diagnostics));
  wire.reason(message.reason);
  return wire;
}

msg::RobotState from_idl(const idl::RobotState& wire, Reading reading) {
  msg::RobotState value;
  value.header = from_idl(wire.header(), reading.in("header"));
  reading.require(wire.robot() == value.header.sender.bytes, "robot", "must be the sender");
  value.name = reading.text("name", wire.name(), kNameLength);
  value.mode = reading.choice("mode", wire.mode(), msg::RobotMode::idle, msg::RobotMode::off);
  value.localised = wire.localised();
  value.place = from_idl(wire.place());
  reading.require(!value.localised || value.place, "place", "must not be none when localised");
  value.place_from_robot = from_idl(wire.place_from_robot(), reading.in("place_from_robot"));
  value.blind_m = reading.not_negative("blind_m", wire.blind_m());
  value.speed_m_s = reading.finite("speed_m_s", wire.speed_m_s());
  value.frame = wire.frame();
  value.experience = ExperienceId{wire.experience()};
  value.goal = id_from<GoalId>(wire.goal());
  value.route = id_from<RouteId>(wire.route());
  value.route_version = wire.route_version();
  value.window_revision = Revision{wire.window_revision()};
  value.window_digest = id_from<Digest>(wire.window_digest());
  value.contents_missing = wire.contents_missing();
  value.memory_bytes = wire.memory_bytes();
  value.memory_cap_bytes = wire.memory_cap_bytes();
  value.diagnostics = list_from_idl<Diagnostic>(wire.diagnostics(), reading, "diagnostics", kDiagnostics);
  value.reason = reading.text("reason", wire.reason(), kTextLength);
  return value;
}

Result<msg::RobotState> from_idl(const idl::RobotState& wire) {
  Reading reading("RobotState");
  auto value = from_idl(wire, reading.here());
  return reading.finish(std::move(value));
}

idl::ClockProbe to_idl(const msg::ClockProbe& message) {
  idl::ClockProbe wire;
  wire.header(to_idl(message.header));
  wire.to(message.to.bytes);
  wire.probe(message.probe);
  wire.sent_ns(nanoseconds(message.sent));
  return wire;
}

Result<msg::ClockProbe> from_idl(const idl::ClockProbe& wire) {
  Reading reading("ClockProbe");
  msg::ClockProbe value;
  value.header = from_idl(wire.header(), reading.in("header"));
  value.to = reading.some("to", id_from<PeerId>(wire.to()));
  value.probe = wire.probe();
  value.sent = wall_from(wire.sent_ns());
  return reading.finish(std::move(value));
}

idl::ClockReply to_idl(const msg::ClockReply& message) {
  idl::ClockReply wire;
  wire.header(to_idl(message.header));
  wire.probe(message.probe);
  wire.probe_sent_ns(nanoseconds(message.probe_sent));
  wire.received_ns(nanoseconds(message.received));
  wire.replied_ns(nanoseconds(message.replied));
  return wire;
}

Result<msg::ClockReply> from_idl(const idl::ClockReply& wire) {
  Reading reading("ClockReply");
  msg::ClockReply value;
  value.header = from_idl(wire.header(), reading.in("header"));
  value.probe = wire.probe();
  value.probe_sent = wall_from(wire.probe_sent_ns());
  value.received = wall_from(wire.received_ns());
  value.replied = wall_from(wire.replied_ns());
  return reading.finish(std::move(value));
}

}  // namespace weft::convert
