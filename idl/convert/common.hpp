#pragma once
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/network/network.hpp"
#include "core/network/removal.hpp"
#include "core/protocol/messages.hpp"
#include "idl/convert/limits.hpp"
#include "idl/convert/visitor.hpp"
#include "wire/common.h"

/// Converts what several messages share: its visitors.
namespace weft::convert {

void describe(Writing& io, const Relation& value, idl::Relation& wire);
void describe(Reading& io, Relation& value, const idl::Relation& wire);

template <class Io>
void describe(Io& io, Value<Io, msg::Header>& value, Wire<Io, idl::Header>& wire) {
  io.some("sender", value.sender, wire.sender());
  io.any(value.incarnation, wire.incarnation());
  io.any(value.epoch, wire.epoch());
  io.any(value.sequence, wire.sequence_number());
  io.list("signature", value.signature, wire.signature(), kSignatureBytes);
}

/// Describes which part of a patch or an answer a message is.
template <class Io, class Message, class WireMessage>
void part_of(Io& io, Message& value, WireMessage& wire) {
  io.any(value.part, wire.part());
  io.between("parts", value.parts, wire.parts(), 1, kParts);
  io.require(value.part < value.parts, "part", "must be below parts");
}

template <class Io>
void describe(Io& io, Value<Io, PlaceId>& value, Wire<Io, idl::PlaceId>& wire) {
  io.any(value.experience, wire.experience());
  io.any(value.index, wire.index());
}

template <class Io>
void places(Io& io, std::string_view field, Value<Io, std::vector<PlaceId>>& value,
            Wire<Io, std::vector<idl::PlaceId>>& wire, std::size_t most) {
  const std::size_t size = io.entries(field, value, wire, most);
  for (std::size_t i = 0; i < size; ++i) io.some(field, value[i], wire[i]);
}

template <class Io>
void describe(Io& io, Value<Io, Place>& value, Wire<Io, idl::Place>& wire) {
  io.some("id", value.id, wire.id());
  io.any(value.entity_version, wire.entity_version());
  io.text("method", value.method, wire.method(), kNameLength);
  io.any(value.content_format, wire.content_format());
  io.some("content_hash", value.content.hash, wire.content_hash());
  io.any(value.content.size, wire.content_size());
  io.require(value.content.size <= msg::kContentBytes, "content_size", "is larger than the largest content");
  io.some("robot", value.robot, wire.robot());
  io.any(value.frame, wire.frame());
  io.any(value.seen_at, wire.seen_at_ns());
}

template <class Io>
void describe(Io& io, Value<Io, EdgeId>& value, Wire<Io, idl::EdgeId>& wire) {
  io.some("a", value.a, wire.a());
  io.some("b", value.b, wire.b());
  io.require(value.a != value.b, "b", "must not be the edge's other end");
}

template <class Io>
void describe(Io& io, Value<Io, Edge>& value, Wire<Io, idl::Edge>& wire) {
  io.in("id", value.id, wire.id());
  io.any(value.entity_version, wire.entity_version());
  io.in("a_from_b", value.a_from_b, wire.a_from_b());
  io.choice("origin", value.origin, wire.origin(), Origin::odometry, Origin::stitch);
  io.text("method", value.method, wire.method(), kNameLength);
  io.choice("drivable", value.drivable, wire.drivable(), Drivable::none, Drivable::both);
  io.any(value.inliers, wire.inliers());
  io.share("overlap", value.overlap, wire.overlap());
}

template <class Io>
void describe(Io& io, Value<Io, Stretch>& value, Wire<Io, idl::Stretch>& wire) {
  io.some("experience", value.experience, wire.experience());
  io.any(value.first, wire.first());
  io.any(value.last, wire.last());
  io.require(value.first <= value.last, "last", "must not be before first");
}

template <class Io>
void describe(Io& io, Value<Io, Apart>& value, Wire<Io, idl::Apart>& wire) {
  io.in("one", value.one, wire.one());
  io.in("other", value.other, wire.other());
}

template <class Io>
void describe(Io& io, Value<Io, std::pair<std::string, PlaceId>>& value, Wire<Io, idl::Label>& wire) {
  io.some("place", value.second, wire.place());
  io.text("name", value.first, wire.name(), kNameLength);
}

template <class Io>
void labels(Io& io, Value<Io, std::map<std::string, PlaceId>>& value, Wire<Io, std::vector<idl::Label>>& wire,
            std::size_t most) {
  std::vector<std::pair<std::string, PlaceId>> list(value.begin(), value.end());
  const std::size_t size = io.entries("labels", list, wire, most);
  for (std::size_t i = 0; i < size; ++i) {
    io.in("labels", list[i], wire[i]);
    if constexpr (Io::kReads) {
      io.require(value.insert(std::move(list[i])).second, "labels.name", "must not stand twice");
    }
  }
}

template <class Io>
void describe(Io& io, Value<Io, Span>& value, Wire<Io, idl::Span>& wire) {
  io.some("from", value.from, wire.from_place());
  io.some("to", value.to, wire.to_place());
}

/// Describes a point that lies within reach of its origin.
template <class Io, class Vector>
void point(Io& io, std::string_view field, Vector& value, Wire<Io, double>& x, Wire<Io, double>& y) {
  io.finite(field, value.x(), x);
  io.finite(field, value.y(), y);
  io.require(std::abs(value.x()) <= kPlanReach_m && std::abs(value.y()) <= kPlanReach_m, field,
             "must be within 1000000 m");
}

template <class Io>
void describe(Io& io, Value<Io, Area>& value, Wire<Io, idl::Area>& wire) {
  io.text("plan", value.plan, wire.plan(), kNameLength);
  io.any(value.plan_hash, wire.plan_hash());
  const std::size_t size = io.entries("corners", value.corners, wire.corners(), kMostCorners);
  io.require(size >= kLeastCorners, "corners", "must be 3 or more");
  for (std::size_t i = 0; i < size; ++i) {
    point(io, "corners[" + std::to_string(i) + "]", value.corners[i], wire.corners()[i].x(), wire.corners()[i].y());
  }
}

template <class Io>
void describe(Io& io, Value<Io, Rule>& value, Wire<Io, idl::Rule>& wire) {
  io.text("name", value.name, wire.name(), kNameLength);
  io.choice("kind", value.kind, wire.kind(), RuleKind::closed, RuleKind::hold);
  io.not_negative("value", value.value, wire.value());
  io.require(value.value <= kMostRobots, "value", "must be at most 1000");
  io.any(value.one_direction, wire.one_direction());
  io.each("spans", value.spans, wire.spans(), kRuleSpans);
  io.text("label", value.label, wire.label(), kNameLength);
  io.not_negative("within_m", value.within_m, wire.within_m());
  io.require(value.within_m <= kRuleWithin_m, "within_m", "must be at most 1000");
  if (io.is_there(value.area.has_value(), wire.has_area())) {
    if constexpr (Io::kReads) {
      io.in("area", value.area.emplace(), wire.area());
    } else {
      io.in("area", value.area.value_or(Area{}), wire.area());
    }
  }
}

template <class Io>
void describe(Io& io, Value<Io, Pick>& value, Wire<Io, idl::Pick>& wire) {
  io.text("name", value.name, wire.name(), kNameLength);
  io.some("place", value.place, wire.place());
  point(io, "in_place", value.in_place, wire.in_place_x_m(), wire.in_place_y_m());
  point(io, "on_plan", value.on_plan, wire.on_plan_x_m(), wire.on_plan_y_m());
  io.finite("sigma_m", value.sigma_m, wire.sigma_m());
  io.require(value.sigma_m >= kLeastPickSigma_m && value.sigma_m <= kMostPickSigma_m, "sigma_m",
             "must be from 0.001 to 10");
  if (io.is_there(value.heading.has_value(), wire.has_heading())) {
    if constexpr (Io::kReads) {
      io.finite("heading_rad", value.heading.emplace(), wire.heading_rad());
    } else {
      io.finite("heading_rad", value.heading.value_or(0.0), wire.heading_rad());
    }
  }
}

template <class Io>
void describe(Io& io, Value<Io, Registration>& value, Wire<Io, idl::Registration>& wire) {
  io.text("plan", value.plan, wire.plan(), kNameLength);
  io.any(value.plan_hash, wire.plan_hash());
  io.each("picks", value.picks, wire.picks(), kMostPicks);
}

template <class Io>
void describe(Io& io, Value<Io, SpeedLimit>& value, Wire<Io, idl::SpeedLimit>& wire) {
  io.any(value.from, wire.first());
  io.any(value.to, wire.last());
  io.require(value.from <= value.to, "last", "must not be before first");
  io.finite("limit_m_s", value.limit_m_s, wire.limit_m_s());
  io.require(value.limit_m_s > 0.0 && value.limit_m_s <= kFastestLimit_m_s, "limit_m_s",
             "must be above 0 and at most 10");
}

/// Describes the limits of a route with so many places.
template <class Io>
void limits(Io& io, Value<Io, std::vector<SpeedLimit>>& value, Wire<Io, std::vector<idl::SpeedLimit>>& wire,
            std::size_t places) {
  io.each("limits", value, wire, kRouteLimits);
  std::uint32_t from = 0;
  for (const SpeedLimit& limit : value) {
    io.require(limit.to < places, "limits", "must be of places of the route");
    io.require(from <= limit.from, "limits", "must be in the order of their first places");
    from = limit.from;
  }
}

template <class Io>
void describe(Io& io, Value<Io, Route>& value, Wire<Io, idl::Route>& wire) {
  io.any(value.goal, wire.goal());
  io.some("id", value.id, wire.id());
  io.any(value.version, wire.version());
  io.any(value.made_of, wire.made_of());
  io.some("robot", value.robot, wire.robot());
  places(io, "places", value.places, wire.places(), kRoutePlaces);
  io.each("relations", value.relations, wire.relations(), kRoutePlaces);
  const std::size_t size = value.places.size();
  io.require(value.relations.size() == (size == 0 ? 0 : size - 1), "relations", "must be one fewer than places");
  io.any(value.released, wire.released());
  io.require(value.released < size || (size == 0 && value.released == 0), "released", "must be the index of a place");
  limits(io, value.limits, wire.limits(), size);
  io.any(value.ended, wire.ended());
  io.text("reason", value.reason, wire.reason(), kTextLength);
}

/// Describes numbers with names for people.
template <class Io>
void counts(Io& io, std::string_view field, Value<Io, std::vector<std::pair<std::string, std::uint64_t>>>& value,
            Wire<Io, std::vector<idl::NamedCount>>& wire) {
  const std::size_t size = io.entries(field, value, wire, kCounters);
  for (std::size_t i = 0; i < size; ++i) {
    io.text(field, value[i].first, wire[i].name(), kTextLength);
    io.any(value[i].second, wire[i].count());
  }
}

/// Describes a line to teach along.
template <class Io>
void describe(Io& io, Value<Io, std::vector<msg::AgentCommand::Point>>& value,
              Wire<Io, std::vector<idl::SitePoint>>& wire) {
  const std::size_t size = io.entries("points", value, wire, kLinePoints);
  for (std::size_t i = 0; i < size; ++i) {
    io.finite("x", value[i].x, wire[i].x());
    io.finite("y", value[i].y, wire[i].y());
  }
}

template <class Io>
void describe(Io& io, Value<Io, Diagnostic>& value, Wire<Io, idl::Diagnostic>& wire) {
  io.text("name", value.name, wire.name(), kNameLength);
  io.finite("value", value.value, wire.value());
  io.not_negative("sigma", value.sigma, wire.sigma());
  io.finite("bound", value.bound, wire.bound());
}

template <class Io>
void describe(Io& io, Value<Io, msg::TaughtStretch>& value, Wire<Io, idl::TaughtStretch>& wire) {
  io.not_negative("from_m", value.from_m, wire.from_m());
  io.not_negative("to_m", value.to_m, wire.to_m());
  io.require(value.from_m <= value.to_m, "to_m", "must not be before from_m");
  io.any(value.places, wire.places());
  io.some("first", value.first, wire.first());
  io.each("found", value.found, wire.found(), msg::kReportConditions);
  for (std::size_t i = 0; i < value.found.size(); ++i) {
    const double share = value.found[i].value;
    io.require(share >= 0.0 && share <= 1.0, "found[" + std::to_string(i) + "].value", "must be from 0 to 1");
  }
  io.not_negative("sigma_m", value.sigma_m, wire.sigma_m());
  io.text("reason", value.reason, wire.reason(), kNameLength);
}

}  // namespace weft::convert
