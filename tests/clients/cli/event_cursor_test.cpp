#include "clients/cli/event_cursor.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace weft::cli::test {
namespace {
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

msg::QueryReply reply_with(std::vector<std::uint64_t> numbers, std::uint64_t oldest, std::uint64_t newest) {
  msg::QueryReply reply;
  for (const std::uint64_t number : numbers) {
    reply.events.emplace_back();
    reply.events.back().number = number;
  }
  reply.oldest_event = oldest;
  reply.newest_event = newest;
  return reply;
}

std::vector<std::uint64_t> numbers_of(const EventCursor::Taken& taken) {
  std::vector<std::uint64_t> numbers;
  for (const msg::Event& event : taken.events) numbers.push_back(event.number);
  return numbers;
}

TEST(EventCursor, ShowsEachEventOnce) {
  EventCursor cursor(5);
  EXPECT_THAT(numbers_of(cursor.take(reply_with({6, 8}, 1, 9), 10)), ElementsAre(6, 8));
  EXPECT_EQ(cursor.after(), 9U) << "what does not fit the filter needs no second look";
  EXPECT_THAT(numbers_of(cursor.take(reply_with({8, 9, 10}, 1, 10), 10)), ElementsAre(10));
  EXPECT_THAT(numbers_of(cursor.take(reply_with({}, 1, 10), 10)), IsEmpty());
}

TEST(EventCursor, AFullAnswerIsFollowedByMore) {
  EventCursor cursor(5);
  const EventCursor::Taken taken = cursor.take(reply_with({6, 7}, 1, 20), 2);
  EXPECT_FALSE(taken.is_all);
  EXPECT_EQ(cursor.after(), 7U);
  EXPECT_TRUE(cursor.take(reply_with({20}, 1, 20), 2).is_all);
}

TEST(EventCursor, SaysWhatIsNotKeptAnyMore) {
  EventCursor cursor(5);
  EXPECT_EQ(cursor.take(reply_with({6}, 6, 6), 10).lost, "") << "the next one is there";
  EXPECT_EQ(cursor.take(reply_with({9}, 9, 9), 10).lost, "events 7 to 8 are not kept any more");
  EventCursor fresh;
  EXPECT_EQ(fresh.take(reply_with({9}, 9, 9), 10).lost, "") << "it begins with what there is";
}

TEST(EventCursor, GoesOnBehindAStoreThatWasExchanged) {
  EventCursor cursor(50);
  const EventCursor::Taken taken = cursor.take(reply_with({}, 1, 30), 10);
  EXPECT_THAT(taken.lost, HasSubstr("another store, whose last event is number 30 and not 50"));
  EXPECT_EQ(cursor.after(), 30U);
  EXPECT_THAT(numbers_of(cursor.take(reply_with({31}, 1, 31), 10)), ElementsAre(31));
}

}  // namespace
}  // namespace weft::cli::test
