#include "core/network/codec.hpp"
#include "core/network/fields.hpp"
#include "core/network/rule.hpp"

namespace weft {
namespace {

template <class Id>
void write_optional(ByteWriter& out, const std::optional<Id>& id) {
  out.flag(id.has_value());
  if (id) out.id(*id);
}

template <class Id>
std::optional<Id> read_optional(ByteReader& in, const char* field) {
  if (!in.flag(field)) return std::nullopt;
  return in.id<Id>(field);
}

GoalState read_state(ByteReader& in, const char* field) {
  return static_cast<GoalState>(in.ranged(field, static_cast<std::uint8_t>(GoalState::pending),
                                          static_cast<std::uint8_t>(GoalState::rejected)));
}

GoalEvent read_event(ByteReader& in) {
  GoalEvent event;
  event.at = WallTime(Duration(in.i64("event at")));
  event.state = read_state(in, "event state");
  event.cause = in.text("event cause");
  event.who = in.text("event who");
  return event;
}

constexpr std::size_t kEventLeast = 8 + 1 + 4 + 4;

Goal read_goal(ByteReader& in) {
  Goal goal;
  goal.id = in.id<GoalId>("goal id");
  goal.label = in.text("label");
  goal.to = in.place_id("to");
  goal.wanted = read_optional<RobotId>(in, "wanted");
  goal.robot = read_optional<RobotId>(in, "robot");
  goal.state = read_state(in, "state");
  goal.number = in.number<std::uint64_t>("number");
  goal.route = read_optional<RouteId>(in, "route");
  goal.route_version = in.number<std::uint32_t>("route version");
  goal.priority = in.ranged<std::uint8_t>("priority", 0, kHighestPriority);
  goal.kind = static_cast<GoalKind>(in.ranged("kind", static_cast<std::uint8_t>(GoalKind::operator_asked),
                                              static_cast<std::uint8_t>(GoalKind::park)));
  goal.no_return = in.flag("no return");
  goal.history.resize(in.count("history", kEventLeast));
  for (GoalEvent& event : goal.history) event = read_event(in);
  return goal;
}

constexpr std::size_t kLimitBytes = 4 + 4 + 8;

/// Reads the limits of a route with so many places.
std::vector<SpeedLimit> read_limits(ByteReader& in, std::size_t places) {
  std::vector<SpeedLimit> limits(in.count("limits", kLimitBytes));
  std::uint32_t from = 0;
  for (SpeedLimit& limit : limits) {
    const std::size_t at = in.offset();
    limit.from = in.number<std::uint32_t>("limit from");
    limit.to = in.number<std::uint32_t>("limit to");
    limit.limit_m_s = in.f64("limit");
    const bool is_in = from <= limit.from && limit.from <= limit.to && limit.to < places;
    if (!is_in) in.corrupt("limit", at, "must be of places of the route, behind the limit before it");
    const bool is_speed = limit.limit_m_s > 0.0 && limit.limit_m_s <= kFastestLimit_m_s;
    if (!is_speed) in.corrupt("limit", at, "is not a speed of over 0 and at most 10 m/s");
    from = limit.from;
  }
  return limits;
}

Route read_route(ByteReader& in) {
  Route route;
  route.goal = in.id<GoalId>("goal");
  route.id = in.id<RouteId>("route id");
  route.version = in.number<std::uint32_t>("version");
  route.made_of.value = in.number<std::uint64_t>("made of");
  route.robot = in.id<RobotId>("robot");
  route.places.resize(in.count("places", fields::kPlaceIdBytes));
  for (PlaceId& place : route.places) place = in.place_id("route place");
  const std::size_t at = in.offset();
  route.relations.resize(in.count("relations", fields::kRelationLeast));
  for (Relation& relation : route.relations) relation = fields::read_relation(in);
  const std::size_t joints = route.places.empty() ? 0 : route.places.size() - 1;
  if (route.relations.size() != joints) in.corrupt("relations", at, "must be one fewer than the places");
  const std::size_t released_at = in.offset();
  route.released = in.number<std::uint32_t>("released");
  if (route.released > joints) in.corrupt("released", released_at, "is past the last place");
  route.limits = read_limits(in, route.places.size());
  route.ended = in.flag("ended");
  route.reason = in.text("reason");
  return route;
}

}  // namespace

Bytes encode(const Goal& goal) {
  return fields::record([&](ByteWriter& out) {
    out.id(goal.id);
    out.text(goal.label);
    out.id(goal.to);
    write_optional(out, goal.wanted);
    write_optional(out, goal.robot);
    out.number(static_cast<std::uint8_t>(goal.state));
    out.number(goal.number);
    write_optional(out, goal.route);
    out.number(goal.route_version);
    out.number(goal.priority);
    out.number(static_cast<std::uint8_t>(goal.kind));
    out.flag(goal.no_return);
    out.count(goal.history.size());
    for (const GoalEvent& event : goal.history) {
      out.i64(event.at.time_since_epoch().count());
      out.number(static_cast<std::uint8_t>(event.state));
      out.text(event.cause);
      out.text(event.who);
    }
  });
}

Bytes encode(const Route& route) {
  return fields::record([&](ByteWriter& out) {
    out.id(route.goal);
    out.id(route.id);
    out.number(route.version);
    out.number(route.made_of.value);
    out.id(route.robot);
    out.count(route.places.size());
    for (const PlaceId& place : route.places) out.id(place);
    out.count(route.relations.size());
    for (const Relation& relation : route.relations) fields::write(out, relation);
    out.number(route.released);
    out.count(route.limits.size());
    for (const SpeedLimit& limit : route.limits) {
      out.number(limit.from);
      out.number(limit.to);
      out.f64(limit.limit_m_s);
    }
    out.flag(route.ended);
    out.text(route.reason);
  });
}

Result<Goal> decode_goal(ByteView bytes) {
  return fields::whole<Goal>(bytes, "goal", read_goal);
}

Result<Route> decode_route(ByteView bytes) {
  return fields::whole<Route>(bytes, "route", read_route);
}

}  // namespace weft
