#include "agents/control/grid/costmap.hpp"

#include <gtest/gtest.h>

namespace weft::agents {
namespace {

SensorTime at(double s) {
  return SensorTime(from_seconds(s));
}

/// Looks 40 degrees to either side.
Scan scan_of(Beam::Return kind, double range_m, double clear_m) {
  Scan scan;
  for (int degree = -80; degree <= 80; ++degree)
    scan.beams.push_back({0.5 * degree * 0.0174533, range_m, 0.02, clear_m, kind});
  return scan;
}

CellState state(const Costmap& map, double x, double y, double now_s) {
  return map.grid(at(now_s)).at(Eigen::Vector2d(x, y));
}

TEST(Costmap, ClearsAlongARayAndMarksItsEnd) {
  Costmap map({});
  map.take({0, 0, 0}, scan_of(Beam::Return::obstacle, 2.0, 2.0), at(1.0));
  EXPECT_EQ(state(map, 1.0, 0.0, 1.0), CellState::free);
  EXPECT_EQ(state(map, 2.0, 0.01, 1.0), CellState::occupied);
  EXPECT_EQ(state(map, 2.2, 0.0, 1.0), CellState::unknown);
  EXPECT_EQ(state(map, 0.0, 1.0, 1.0), CellState::unknown) << "it did not look there";
}

TEST(Costmap, ARayWithoutAReturnIsFreeOnlyAsFarAsItWasSeenToBe) {
  Costmap map({});
  map.take({0, 0, 0}, scan_of(Beam::Return::none, 0.0, 0.8), at(1.0));
  EXPECT_EQ(state(map, 0.7, 0.0, 1.0), CellState::free);
  EXPECT_EQ(state(map, 0.9, 0.0, 1.0), CellState::unknown);
  map.clear();
  map.take({0, 0, 0}, scan_of(Beam::Return::none, 0.0, 0.0), at(1.0));
  EXPECT_EQ(state(map, 0.5, 0.0, 1.0), CellState::unknown);
}

TEST(Costmap, WhereTheRobotStandsIsFree) {
  Costmap map({});
  map.take({1.0, 2.0, 0.5}, Scan{}, at(0.0));
  EXPECT_EQ(state(map, 1.0, 2.2, 0.0), CellState::free);
  EXPECT_EQ(state(map, 1.0, 2.4, 0.0), CellState::unknown);
}

TEST(Costmap, ForgetsAfterItsMemory) {
  Costmap map({});
  map.take({0, 0, 0}, scan_of(Beam::Return::obstacle, 2.0, 2.0), at(1.0));
  EXPECT_EQ(state(map, 2.0, 0.01, 10.9), CellState::occupied);
  EXPECT_EQ(state(map, 2.0, 0.01, 11.1), CellState::unknown);
}

TEST(Costmap, ARayOverALowThingThatIsOutOfViewDoesNotClearIt) {
  Costmap map({});
  map.take({0, 0, 0}, scan_of(Beam::Return::obstacle, 1.0, 1.0), at(1.0));
  Scan past = scan_of(Beam::Return::none, 0.0, 5.0);  // of the wall behind it
  past.clear_from_m = 0.6;
  map.take({0.5, 0, 0}, past, at(2.0));
  EXPECT_EQ(state(map, 1.0, 0.01, 2.0), CellState::occupied);
  EXPECT_EQ(state(map, 1.2, 0.0, 2.0), CellState::free);
  past.clear_from_m = 0.4;
  map.take({0.5, 0, 0}, past, at(3.0));
  EXPECT_EQ(state(map, 1.0, 0.01, 3.0), CellState::free);
}

TEST(Costmap, WhatStandsTooNearToBeSeenIsKept) {
  Costmap map({});
  map.take({0, 0, 0}, scan_of(Beam::Return::obstacle, 1.0, 1.0), at(1.0));
  map.take({0.4, 0, 0}, Scan{}, at(2.0));  // in front of it, blind
  EXPECT_EQ(state(map, 1.0, 0.01, 50.0), CellState::occupied);
  map.clear();
  EXPECT_EQ(state(map, 1.0, 0.01, 50.0), CellState::occupied);
  EXPECT_EQ(state(map, 1.0, 0.01, 62.0), CellState::unknown);
  map.take({0.4, 0, 0}, scan_of(Beam::Return::obstacle, 2.0, 2.0), at(3.0));
  EXPECT_EQ(state(map, 1.0, 0.01, 3.0), CellState::free) << "seen to have gone";
}

TEST(Costmap, WhatHasGoneIsCleared) {
  Costmap map({});
  map.take({0, 0, 0}, scan_of(Beam::Return::obstacle, 1.0, 1.0), at(1.0));
  map.take({0, 0, 0}, scan_of(Beam::Return::obstacle, 2.5, 2.5), at(1.1));
  EXPECT_EQ(state(map, 1.0, 0.01, 1.1), CellState::free);
}

TEST(Costmap, RollsWithTheRobotAndKeepsWhatIsBehindItsView) {
  Costmap map({});
  map.take({0, 0, 0}, scan_of(Beam::Return::obstacle, 1.0, 1.0), at(1.0));
  map.take({2.0, 0, 0}, Scan{}, at(2.0));
  EXPECT_EQ(state(map, 1.0, 0.01, 2.0), CellState::occupied) << "behind it now";
  map.take({8.0, 0, 0}, Scan{}, at(3.0));
  EXPECT_EQ(state(map, 1.0, 0.01, 3.0), CellState::unknown) << "out of the square";
  map.take({0.0, 0, 0}, Scan{}, at(4.0));
  EXPECT_EQ(state(map, 1.0, 0.01, 4.0), CellState::unknown) << "what left the square is forgotten";
}

TEST(Costmap, ASensorThatIsMountedAsideSeesFromThere) {
  Costmap map({});
  Scan scan = scan_of(Beam::Return::obstacle, 1.0, 1.0);
  scan.robot_from_scan = {0.5, 0.0, 1.5707963};
  map.take({0, 0, 0}, scan, at(0.0));
  EXPECT_EQ(state(map, 0.47, 0.99, 0.0), CellState::occupied);
}

}  // namespace
}  // namespace weft::agents
