#pragma once
#include "agents/methods/method.hpp"
#include "agents/navigation/config.hpp"

namespace weft::agents {

/// Returns how fast a robot may drive, m/s, as well as it knows where it is: `speed_m_s` while it sees its places and
/// knows its position across its way; less the longer it goes without a fix, so that it has slowed down before it is
/// lost, and in inverse proportion to the position's sigma, so that it is met with time to be corrected. Never below
/// `unsure_share` of `speed_m_s`: a robot that crawls finds no more.
double speed_limit(const FollowConfig& config, const Estimate& estimate);

}  // namespace weft::agents
