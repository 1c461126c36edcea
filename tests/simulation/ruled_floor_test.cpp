#include "tests/simulation/ruled_floor.hpp"

#include <gtest/gtest.h>

namespace weft::simulation {
namespace {

constexpr ExperienceId kThere{1};
constexpr ExperienceId kBack{2};

/// Returns where places lie of two runs over one floor, 0.25 m from place to place; the second run leads back.
std::optional<Pose2> lies(const PlaceId& place) {
  const double along_m = 0.25 * place.index;
  return place.experience == kThere ? Pose2{along_m, 0.0, 0.0} : Pose2{10.0 - along_m, 0.0, 3.14};
}

/// Closes the floor from 5 to 6 m along the first run.
Rule closed() {
  Rule rule;
  rule.name = "closed";
  rule.spans = {{{kThere, 20}, {kThere, 24}}};
  return rule;
}

Route along(ExperienceId run, std::uint32_t first, std::uint32_t last) {
  Route route;
  for (std::uint32_t index = first; index <= last; ++index) route.places.push_back({run, index});
  route.released = last - first;
  return route;
}

TEST(ClosedFloor, IsEnteredByAWayThatLeadsIn) {
  EXPECT_EQ(enters_closed(closed(), along(kThere, 10, 22), 1, lies), (PlaceId{kThere, 20}));
}

TEST(ClosedFloor, IsNotEnteredByAReleaseThatEndsBeforeIt) {
  Route route = along(kThere, 10, 22);
  route.released = 8;
  EXPECT_EQ(enters_closed(closed(), route, 1, lies), std::nullopt);
}

TEST(ClosedFloor, IsTheSameFloorWhicheverRunLeadsThere) {
  EXPECT_EQ(enters_closed(closed(), along(kBack, 0, 20), 1, lies), (PlaceId{kBack, 16}));
}

TEST(ClosedFloor, MayBeLeftAndIsNotEnteredAgain) {
  EXPECT_EQ(enters_closed(closed(), along(kThere, 22, 36), 1, lies), std::nullopt);
  Route round = along(kThere, 22, 30);
  const Route again = along(kThere, 10, 22);
  round.places.insert(round.places.end(), again.places.begin(), again.places.end());
  round.released = static_cast<std::uint32_t>(round.places.size() - 1);
  EXPECT_EQ(enters_closed(closed(), round, 1, lies), (PlaceId{kThere, 20}));
}

TEST(ClosedFloor, WhatWasReleasedBeforeItWasClosedIsNotAsked) {
  EXPECT_EQ(enters_closed(closed(), along(kThere, 10, 22), 12, lies), std::nullopt);
}

/// Slows the same floor.
Rule slow() {
  Rule rule = closed();
  rule.kind = RuleKind::speed;
  rule.value = 0.3;
  return rule;
}

TEST(SlowFloor, IsDrivenWithALimitAsLowWhicheverRunLeadsThere) {
  Route route = along(kBack, 0, 30);
  EXPECT_EQ(lacks_limit(slow(), route, 0, lies), (PlaceId{kBack, 16}));
  route.limits = {{.from = 10, .to = 17, .limit_m_s = 0.3}};
  EXPECT_EQ(lacks_limit(slow(), route, 0, lies), (PlaceId{kBack, 18}));
  route.limits.push_back({.from = 18, .to = 20, .limit_m_s = 0.4});
  EXPECT_EQ(lacks_limit(slow(), route, 0, lies), (PlaceId{kBack, 18}));
  route.limits.push_back({.from = 0, .to = 20, .limit_m_s = 0.2});
  EXPECT_EQ(lacks_limit(slow(), route, 0, lies), std::nullopt);
}

TEST(SlowFloor, NeedsNoLimitWhereNothingIsReleased) {
  Route route = along(kThere, 10, 30);
  route.released = 8;
  EXPECT_EQ(lacks_limit(slow(), route, 0, lies), std::nullopt);
  route.released = 12;
  EXPECT_EQ(lacks_limit(slow(), route, 0, lies), (PlaceId{kThere, 20}));
  EXPECT_EQ(lacks_limit(slow(), route, 15, lies), std::nullopt);
}

}  // namespace
}  // namespace weft::simulation
