#pragma once
#include "idl/convert/common.hpp"
#include "wire/session.h"

namespace weft::convert {

template <class Io>
void describe(Io& io, Value<Io, msg::Hello>& value, Wire<Io, idl::Hello>& wire) {
  io.some("peer", value.peer, wire.peer());
  io.any(value.incarnation, wire.incarnation());
  io.choice("role", value.role, wire.role(), msg::Role::server, msg::Role::client);
  io.any(value.protocol_min, wire.protocol_min());
  io.any(value.protocol_max, wire.protocol_max());
  io.require(value.protocol_min <= value.protocol_max, "protocol_max", "must be at least protocol_min");
  io.any(value.epoch, wire.epoch());
  io.text("name", value.name, wire.name(), kNameLength);
  io.text("software", value.software, wire.software(), kNameLength);
  io.text("vendor", value.vendor, wire.vendor(), kNameLength);
  io.any(value.challenge, wire.challenge());
  io.list("answers", value.answers, wire.answers(), msg::kAnswers);
}

template <class Io>
void describe(Io& io, Value<Io, msg::Camera>& value, Wire<Io, idl::Camera>& wire) {
  io.text("id", value.id, wire.id(), kNameLength);
  io.any(value.width, wire.width());
  io.any(value.height, wire.height());
  io.text("calibration", value.calibration, wire.calibration(), kCalibrationLength);
}

template <class Io>
void describe(Io& io, Value<Io, msg::RobotDescription>& value, Wire<Io, idl::RobotDescription>& wire) {
  io.in("header", value.header, wire.header());
  io.again("robot", value.header.sender, wire.robot(), "must be the sender");
  io.text("name", value.name, wire.name(), kNameLength);
  io.text("body", value.body, wire.body(), kNameLength);
  io.texts("methods", value.methods, wire.methods(), kMethods, kNameLength);
  io.finite("footprint_radius_m", value.footprint_radius_m, wire.footprint_radius_m());
  io.require(value.footprint_radius_m > 0.0 && value.footprint_radius_m <= 5.0, "footprint_radius_m",
             "must be above 0 and at most 5");
  io.any(value.can_be_taught_along, wire.can_be_taught_along());
  io.each("cameras", value.cameras, wire.cameras(), kCameras);
  io.any(value.knows_limits, wire.knows_limits());
}

template <class Io>
void describe(Io& io, Value<Io, msg::RobotState>& value, Wire<Io, idl::RobotState>& wire) {
  io.in("header", value.header, wire.header());
  io.again("robot", value.header.sender, wire.robot(), "must be the sender");
  io.text("name", value.name, wire.name(), kNameLength);
  io.choice("mode", value.mode, wire.mode(), msg::RobotMode::idle, msg::RobotMode::off);
  io.any(value.localised, wire.localised());
  io.any(value.place, wire.place());
  io.require(!value.localised || value.place, "place", "must not be none when localised");
  io.in("place_from_robot", value.place_from_robot, wire.place_from_robot());
  io.not_negative("blind_m", value.blind_m, wire.blind_m());
  io.finite("speed_m_s", value.speed_m_s, wire.speed_m_s());
  io.any(value.frame, wire.frame());
  io.any(value.experience, wire.experience());
  io.any(value.goal, wire.goal());
  io.any(value.route, wire.route());
  io.any(value.route_version, wire.route_version());
  io.any(value.window_revision, wire.window_revision());
  io.any(value.window_digest, wire.window_digest());
  io.any(value.contents_missing, wire.contents_missing());
  io.any(value.memory_bytes, wire.memory_bytes());
  io.any(value.memory_cap_bytes, wire.memory_cap_bytes());
  io.each("diagnostics", value.diagnostics, wire.diagnostics(), kDiagnostics);
  io.choice("safety", value.safety, wire.safety(), Safety::ok, Safety::blocked);
  io.any(value.spool_batches, wire.spool_batches());
  std::uint64_t spool_free_bytes = value.spool_free_bytes.value_or(0);
  if (io.is_there(value.spool_free_bytes.has_value(), wire.has_spool_free_bytes())) {
    io.any(spool_free_bytes, wire.spool_free_bytes());
    if constexpr (Io::kReads) value.spool_free_bytes = spool_free_bytes;
  }
  io.not_negative("server_unheard_s", value.server_unheard_s, wire.server_unheard_s());
  io.not_negative("server_gap_s", value.server_gap_s, wire.server_gap_s());
  io.text("reason", value.reason, wire.reason(), kTextLength);
  io.text("spool_refuses", value.spool_refuses, wire.spool_refuses(), kTextLength);
}

template <class Io>
void describe(Io& io, Value<Io, msg::RobotPower>& value, Wire<Io, idl::RobotPower>& wire) {
  io.in("header", value.header, wire.header());
  io.again("robot", value.header.sender, wire.robot(), "must be the sender");
  io.share("share", value.share, wire.share());
  io.any(value.is_charging, wire.is_charging());
  double minutes = value.minutes.value_or(0.0);
  if (io.is_there(value.minutes.has_value(), wire.has_minutes())) {
    io.not_negative("minutes", minutes, wire.minutes());
    if constexpr (Io::kReads) value.minutes = minutes;
  }
}

template <class Io>
void describe(Io& io, Value<Io, msg::Echo>& value, Wire<Io, idl::Echo>& wire) {
  io.in("header", value.header, wire.header());
  io.any(value.to, wire.to());
  io.any(value.request, wire.request());
  io.any(value.number, wire.number());
  io.any(value.load, wire.load());
  io.require_at_most(value.load.size(), msg::kEchoBytes, "load", " bytes");
}

template <class Io>
void describe(Io& io, Value<Io, msg::ClockProbe>& value, Wire<Io, idl::ClockProbe>& wire) {
  io.in("header", value.header, wire.header());
  io.some("to", value.to, wire.to());
  io.any(value.probe, wire.probe());
  io.any(value.sent, wire.sent_ns());
}

template <class Io>
void describe(Io& io, Value<Io, msg::ClockReply>& value, Wire<Io, idl::ClockReply>& wire) {
  io.in("header", value.header, wire.header());
  io.any(value.probe, wire.probe());
  io.any(value.probe_sent, wire.probe_sent_ns());
  io.any(value.received, wire.received_ns());
  io.any(value.replied, wire.replied_ns());
}

}  // namespace weft::convert
