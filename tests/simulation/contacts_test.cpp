#include "tests/simulation/contacts.hpp"

#include <gtest/gtest.h>

namespace weft::simulation {
namespace {

RobotId robot_of(std::uint8_t number) {
  RobotId id;
  id.bytes[0] = number;
  return id;
}

Stance standing(double x) {
  return {{x, 0.0}, 0.4, false, false};
}

Stance driving(double x) {
  return {{x, 0.0}, 0.4, true, false};
}

Stance led(double x) {
  return {{x, 0.0}, 0.4, false, true};
}

TEST(Contacts, OneThatDrivesIntoAnotherIsSeen) {
  Contacts contacts;
  EXPECT_TRUE(contacts.moved(robot_of(1), standing(1.0)).empty());
  EXPECT_TRUE(contacts.moved(robot_of(2), driving(0.19)).empty());
  const auto touches = contacts.moved(robot_of(2), driving(0.21));
  ASSERT_EQ(touches.size(), 1U);
  EXPECT_EQ(touches[0].other, robot_of(1));
  EXPECT_NEAR(touches[0].gap_m, -0.01, 1e-9);
}

TEST(Contacts, ItIsSeenFromWhicheverSideMovesLast) {
  Contacts contacts;
  contacts.moved(robot_of(2), driving(0.3));
  EXPECT_EQ(contacts.moved(robot_of(1), standing(1.0)).size(), 1U);
}

TEST(Contacts, TwoThatStandTouchNobody) {
  Contacts contacts;
  contacts.moved(robot_of(1), standing(1.0));
  EXPECT_TRUE(contacts.moved(robot_of(2), standing(0.5)).empty());
}

TEST(Contacts, WhatAHandBringsTogetherIsTheHandsDoingUntilTheyAreApart) {
  Contacts contacts;
  contacts.moved(robot_of(1), led(1.0));
  EXPECT_TRUE(contacts.moved(robot_of(2), driving(0.4)).empty());
  contacts.moved(robot_of(1), standing(1.0));
  EXPECT_TRUE(contacts.moved(robot_of(2), driving(0.35)).empty());
  EXPECT_TRUE(contacts.moved(robot_of(2), driving(0.0)).empty());
  EXPECT_EQ(contacts.moved(robot_of(2), driving(0.4)).size(), 1U);
}

TEST(Contacts, WhereAHandPutsARobotDownOnAWayThatWasGivenIsTheHandsDoingUntilItDrivesOff) {
  Contacts contacts;
  contacts.moved(robot_of(1), led(5.0));
  contacts.moved(robot_of(1), standing(5.0));
  contacts.put_down_before(robot_of(1), robot_of(2));
  EXPECT_TRUE(contacts.moved(robot_of(2), driving(4.3)).empty());
  EXPECT_EQ(contacts.moved(robot_of(3), driving(5.7)).size(), 1U);
  contacts.moved(robot_of(3), standing(9.0));
  contacts.moved(robot_of(2), standing(0.0));
  contacts.moved(robot_of(1), driving(5.1));
  EXPECT_EQ(contacts.moved(robot_of(2), driving(4.4)).size(), 1U);
}

}  // namespace
}  // namespace weft::simulation
