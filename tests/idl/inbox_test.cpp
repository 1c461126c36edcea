#include "idl/bus/inbox.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <vector>

namespace weft::bus {
namespace {
using namespace std::chrono_literals;

/// Returns a serialised message that says who put it and as which of his.
Bytes numbered(std::uint8_t writer, std::uint8_t number) {
  return {0, 1, 0, 0, writer, number, 0, 0};
}

TEST(Inbox, WhatSeveralThreadsPutIsTakenOnceAndInEachOnesOrder) {
  constexpr std::uint8_t writers = 4;
  constexpr std::uint8_t each = 200;
  Inbox inbox(std::size_t{writers} * each);
  std::vector<std::jthread> threads;
  for (std::uint8_t writer = 0; writer < writers; ++writer) {
    threads.emplace_back([&inbox, writer] {
      for (std::uint8_t number = 0; number < each; ++number) {
        inbox.put(topic(TopicId::robot_state), numbered(writer, number));
        if (number % 50 == 0) inbox.count_refused_by_vendor();
      }
    });
  }
  std::vector<int> next(writers, 0);
  for (int taken = 0; taken < writers * each;) {
    ASSERT_TRUE(inbox.wait(60s) || inbox.counters().received == std::uint64_t{writers} * each);
    while (const auto delivery = inbox.take()) {
      ASSERT_EQ(delivery->cdr.size(), 8U);
      EXPECT_EQ(delivery->cdr[5], next.at(delivery->cdr[4])++);
      ++taken;
    }
  }
  threads.clear();
  EXPECT_EQ(inbox.counters().received, std::uint64_t{writers} * each);
  EXPECT_EQ(inbox.counters().refused_vendor, std::uint64_t{writers} * each / 50);
  EXPECT_EQ(inbox.counters().dropped_inbox, 0U);
}

TEST(Inbox, AnyThreadWakesWhoeverWaits) {
  Inbox inbox(8);
  const std::jthread waker([&inbox] { inbox.wake(); });
  EXPECT_TRUE(inbox.wait(60s));
  EXPECT_FALSE(inbox.take().has_value());
}

TEST(Inbox, TheOldestGoesWhenItIsFullAndIsCounted) {
  Inbox inbox(2);
  for (std::uint8_t number = 0; number < 5; ++number) inbox.put(topic(TopicId::robot_state), numbered(0, number));
  EXPECT_EQ(inbox.take()->cdr[5], 3);
  EXPECT_EQ(inbox.take()->cdr[5], 4);
  EXPECT_FALSE(inbox.take().has_value());
  EXPECT_EQ(inbox.counters().dropped_inbox, 3U);
}

TEST(Inbox, WhatIsLargerThanItsTopicAllowsIsRefusedAndCounted) {
  Inbox inbox(2);
  const Topic& small = topic(TopicId::robot_state);
  inbox.put(small, Bytes(small.max_bytes + 4));
  EXPECT_FALSE(inbox.take().has_value());
  EXPECT_EQ(inbox.counters().refused_size, 1U);
}

}  // namespace
}  // namespace weft::bus
