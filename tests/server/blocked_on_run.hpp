#pragma once
#include "tests/server/given_up.hpp"
#include "tests/server/run_with_bypass.hpp"

namespace weft::server::test {

/// Arranges the run with its bypass for a robot r1 that finds something in its way.
struct BlockedOnRun : RunWithBypass {
  /// Lets r1 say for so long that it is asked to drive there and does not move.
  void stand_blocked(const Route& route, std::uint32_t at, Duration time) {
    for (Duration past{}; past < time; past += 1s) {
      site.progress(r1, route, msg::RoutePhase::driving, at - 1, at);
      msg::RobotState state = site.driving(r1, route, route.places[at]);
      state.safety = Safety::blocked;
      site.say(state);
      site.pass(1s);
    }
  }
  void give_up(const Route& route, std::uint32_t at) {
    site.progress(r1, route, msg::RoutePhase::driving, at - 1, at);
    msg::RouteProgress progress = given_up(r1, route, "blocked");
    progress.at = at;
    progress.freed = at - 1;
    progress.released = route.released;
    site.say(progress);
  }
  /// Lets r1 obey the order to end its route, and say for some seconds where it stands.
  void obey(const PlaceId& place, int seconds = 2) {
    EXPECT_TRUE(site.order().ended);
    site.stand(r1, place, seconds);
  }
};

}  // namespace weft::server::test
