#pragma once
#include <string>

#include "tests/server/arranged_site.hpp"

namespace weft::server::test {

/// Returns what a robot says that gives a route up; where it is on it is the caller's to add.
inline msg::RouteProgress given_up(Peer& robot, const Route& route, const std::string& reason) {
  msg::RouteProgress progress;
  progress.header = robot.header();
  progress.goal = route.goal;
  progress.route = route.id;
  progress.version = route.version;
  progress.phase = msg::RoutePhase::failed;
  progress.reason = reason;
  return progress;
}

}  // namespace weft::server::test
