#include "agents/agent/missions/place_requests.hpp"

#include <gtest/gtest.h>

#include "tests/agents/agent/bench.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

TEST(PlaceRequests, AllGetTheSamePlace) {
  Bench bench;
  PlaceRequests requests;
  requests.add(bench.key(1), bench.now);
  requests.add(bench.key(2), bench.now);
  const PlaceId kept{ExperienceId{4}, 9};
  requests.answer(kept, bench.replies);
  const std::vector<msg::AgentReply> replies = bench.replied();
  ASSERT_EQ(replies.size(), 2U);
  for (const msg::AgentReply& reply : replies) EXPECT_EQ(reply.place, kept);
  EXPECT_EQ(replies[0].command, 1U);
  EXPECT_EQ(replies[1].command, 2U);
  EXPECT_TRUE(requests.empty());
}

TEST(PlaceRequests, GiveUpFifteenSecondsAfterTheLast) {
  Bench bench;
  PlaceRequests requests;
  EXPECT_FALSE(requests.next().has_value());
  requests.add(bench.key(1), bench.now);
  requests.add(bench.key(2), bench.now + 10s);
  requests.was_away(1s);
  EXPECT_EQ(requests.next(), bench.now + 26s);
  requests.tick(bench.replies, bench.now + 25s);
  EXPECT_TRUE(bench.replied().empty());
  requests.tick(bench.replies, bench.now + 26s);
  const std::vector<msg::AgentReply> replies = bench.replied();
  ASSERT_EQ(replies.size(), 2U);
  EXPECT_FALSE(replies[0].done);
  EXPECT_FALSE(requests.next().has_value());
}

}  // namespace
}  // namespace weft::agents::test
