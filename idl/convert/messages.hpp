#pragma once
#include "core/protocol/messages.hpp"
#include "core/result.hpp"
#include "wire/driving.h"
#include "wire/network.h"
#include "wire/operating.h"
#include "wire/session.h"

/// core <-> IDL, one pair a message. `to_idl` takes what it is given; `from_idl` validates every field and fails with
/// `invalid`, naming the message, the field and the bound.
namespace weft::convert {

idl::Hello to_idl(const msg::Hello& message);
Result<msg::Hello> from_idl(const idl::Hello& wire);
idl::RobotDescription to_idl(const msg::RobotDescription& message);
Result<msg::RobotDescription> from_idl(const idl::RobotDescription& wire);
idl::RobotState to_idl(const msg::RobotState& message);
Result<msg::RobotState> from_idl(const idl::RobotState& wire);
idl::ClockProbe to_idl(const msg::ClockProbe& message);
Result<msg::ClockProbe> from_idl(const idl::ClockProbe& wire);
idl::ClockReply to_idl(const msg::ClockReply& message);
Result<msg::ClockReply> from_idl(const idl::ClockReply& wire);

idl::ExperienceBatch to_idl(const msg::ExperienceBatch& message);
Result<msg::ExperienceBatch> from_idl(const idl::ExperienceBatch& wire);
idl::BatchAck to_idl(const msg::BatchAck& message);
Result<msg::BatchAck> from_idl(const idl::BatchAck& wire);
idl::Chunk to_idl(const msg::Chunk& message);
Result<msg::Chunk> from_idl(const idl::Chunk& wire);
idl::ContentRequest to_idl(const msg::ContentRequest& message);
Result<msg::ContentRequest> from_idl(const idl::ContentRequest& wire);
idl::WindowRequest to_idl(const msg::WindowRequest& message);
Result<msg::WindowRequest> from_idl(const idl::WindowRequest& wire);
idl::WindowPatch to_idl(const msg::WindowPatch& message);
Result<msg::WindowPatch> from_idl(const idl::WindowPatch& wire);
idl::Recognise to_idl(const msg::Recognise& message);
Result<msg::Recognise> from_idl(const idl::Recognise& wire);
idl::Recognised to_idl(const msg::Recognised& message);
Result<msg::Recognised> from_idl(const idl::Recognised& wire);

idl::RouteOrder to_idl(const msg::RouteOrder& message);
Result<msg::RouteOrder> from_idl(const idl::RouteOrder& wire);
idl::RouteProgress to_idl(const msg::RouteProgress& message);
Result<msg::RouteProgress> from_idl(const idl::RouteProgress& wire);
idl::AgentCommand to_idl(const msg::AgentCommand& message);
Result<msg::AgentCommand> from_idl(const idl::AgentCommand& wire);
idl::AgentReply to_idl(const msg::AgentReply& message);
Result<msg::AgentReply> from_idl(const idl::AgentReply& wire);

idl::OperatorRequest to_idl(const msg::OperatorRequest& message);
Result<msg::OperatorRequest> from_idl(const idl::OperatorRequest& wire);
idl::OperatorReply to_idl(const msg::OperatorReply& message);
Result<msg::OperatorReply> from_idl(const idl::OperatorReply& wire);
idl::Query to_idl(const msg::Query& message);
Result<msg::Query> from_idl(const idl::Query& wire);
idl::QueryReply to_idl(const msg::QueryReply& message);
Result<msg::QueryReply> from_idl(const idl::QueryReply& wire);
idl::EventNote to_idl(const msg::EventNote& message);
Result<msg::EventNote> from_idl(const idl::EventNote& wire);

}  // namespace weft::convert
