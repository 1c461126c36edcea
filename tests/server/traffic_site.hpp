#pragma once
#include <gtest/gtest.h>

#include <memory>
#include <optional>

#include "server/traffic/proximity.hpp"
#include "server/traffic/traffic.hpp"
#include "tests/server/one_run.hpp"

namespace weft::server::test {

/// Arranges two robots of 0.4 m on the run: they keep clear of each other from 3 places on.
struct TrafficTest : OneRun {
  TrafficTest() {
    site.arrive(r2, std::nullopt);
    site.label("end", run.place(59));
    site.label("middle", run.place(20));
  }
  /// Lets the robot be heard on its route: a robot that is not heard is released nowhere.
  void drives(Peer& robot) {
    const Route route = *site.order_to(robot);
    site.say(site.driving(robot, route, route.places[1]));
    site.progress(robot, route, msg::RoutePhase::driving, 1);
  }
  void expect_apart() {
    Proximity proximity(3.0);
    proximity.layout().lay(std::make_shared<const Snapshot>(site.service().snapshot()));
    proximity.layout().work(1'000'000);
    const auto& held = site.disk->occupancies;
    for (const auto& [a, one] : held) {
      for (const auto& [b, other] : held) {
        const bool nobody_gave_it = !one.held.id && !other.held.id;
        if (!(a < b) || nobody_gave_it) continue;
        EXPECT_FALSE(proximity.overlap(site.service().snapshot(), touched_by(one, 0.4), touched_by(other, 0.4)))
            << to_string(a) << " and " << to_string(b);
      }
    }
  }
};

}  // namespace weft::server::test
