#include "server/fleet/reception.hpp"

#include <gtest/gtest.h>

#include <chrono>

namespace weft::server {
namespace {
using namespace std::chrono_literals;

/// Counts from the first moment on: what begins only after a while has begun.
struct ReceptionTest : testing::Test {
  ReceptionTest() { reception.hear(1, 1, SteadyTime(0s)); }
  void hear(std::uint64_t sequence, std::uint64_t incarnation = 1) {
    reception.hear(incarnation, sequence, SteadyTime(Reception::kBegins));
  }
  Reception reception;
};

TEST_F(ReceptionTest, NothingIsMissedWhereAllCame) {
  for (std::uint64_t sequence = 100; sequence < 200; ++sequence) hear(sequence);
  EXPECT_EQ(reception.heard(), 100U);
  EXPECT_EQ(reception.missed(), 0U);
}

TEST_F(ReceptionTest, GapsAreMissedUntilWhatWasOvertakenComes) {
  hear(100);
  hear(104);
  EXPECT_EQ(reception.missed(), 3U);
  hear(102);
  EXPECT_EQ(reception.heard(), 3U);
  EXPECT_EQ(reception.missed(), 2U);
}

TEST_F(ReceptionTest, WhatLateJoinersAreGivenFirstDoesNotCount) {
  EXPECT_EQ(reception.heard(), 0U);
  hear(100);
  hear(3);  // older than the first that counted
  EXPECT_EQ(reception.heard(), 1U);
  EXPECT_EQ(reception.missed(), 0U);
}

TEST_F(ReceptionTest, ANewStartBeginsAnew) {
  hear(100);
  hear(200);
  hear(1, 2);
  EXPECT_EQ(reception.heard(), 0U);
  EXPECT_EQ(reception.missed(), 0U);
}

}  // namespace
}  // namespace weft::server
