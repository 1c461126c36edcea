#pragma once
#include <vector>

#include "core/network/network.hpp"
#include "core/protocol/messages.hpp"
#include "server/site/site_frames.hpp"

namespace weft::server {

/// Returns the registered floor plans by name, each with how the map lies on it, as far as that is worked out.
std::vector<msg::RegistrationRow> registration_rows(const Snapshot& map, const SiteFrames& site_frames);

/// Puts in where the robot stands on a registered floor plan, if that is known.
void put_on_plan(const SiteFrames& site_frames, msg::RobotRow& row);

}  // namespace weft::server
