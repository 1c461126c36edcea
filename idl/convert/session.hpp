#pragma once
#include "idl/convert/messages.hpp"
#include "idl/convert/reading.hpp"

/// Descriptions and states also stand inside answers to operators.
namespace weft::convert {

msg::RobotDescription from_idl(const idl::RobotDescription& wire, Reading reading);
msg::RobotState from_idl(const idl::RobotState& wire, Reading reading);

}  // namespace weft::convert
