#pragma once
#include <variant>

#include "core/protocol/map_messages.hpp"
#include "core/protocol/operator_messages.hpp"
#include "core/protocol/peers.hpp"
#include "core/protocol/query_messages.hpp"
#include "core/protocol/robot_messages.hpp"
#include "core/protocol/route_messages.hpp"

/// Holds the messages that cross the wire, as the inside of every process knows them; nothing else crosses it. The
/// IDL of the same names is in idl/. `to` names the peer that a message is for.
namespace weft::msg {

using Message = std::variant<Hello, RobotDescription, RobotState, ExperienceBatch, BatchAck, Chunk, ContentRequest,
                             WindowRequest, WindowPatch, Recognise, Recognised, RouteOrder, RouteProgress,
                             AgentCommand, AgentReply, OperatorRequest, OperatorReply, Query, QueryReply, EventNote,
                             ClockProbe, ClockReply, RobotPower, Echo>;

}  // namespace weft::msg
