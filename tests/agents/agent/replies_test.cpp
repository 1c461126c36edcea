#include "agents/agent/replies.hpp"

#include <gtest/gtest.h>

#include "tests/agents/agent/bench.hpp"

namespace weft::agents::test {
namespace {

TEST(Replies, CommandIsCarriedOutOnceAndItsAnswerRepeated) {
  Bench bench;
  EXPECT_TRUE(bench.replies.is_fresh(bench.key(1)));
  EXPECT_FALSE(bench.replies.is_fresh(bench.key(1)));
  EXPECT_TRUE(bench.replied().empty()) << "there is no answer yet";
  bench.replies.refuse(bench.key(1), "not today");
  EXPECT_EQ(bench.only_reply().reason, "not today");
  EXPECT_FALSE(bench.replies.is_fresh(bench.key(1)));
  EXPECT_EQ(bench.only_reply().reason, "not today");
}

TEST(Replies, SameNumberInAnotherEpochIsAnotherCommand) {
  Bench bench;
  EXPECT_TRUE(bench.replies.is_fresh({Epoch{1}, 1}));
  EXPECT_TRUE(bench.replies.is_fresh({Epoch{2}, 1}));
}

TEST(Outbox, HandsOverEverythingOnceWithConsecutiveHeaders) {
  Bench bench;
  bench.outbox.send(msg::AgentReply{});
  bench.outbox.send(msg::AgentReply{});
  bench.outbox.note("a word");
  bench.outbox.stop_hand();
  const AgentOutput output = bench.outbox.take({0.5, 0.0});
  ASSERT_EQ(output.send.size(), 2U);
  const std::uint64_t first = std::get<msg::AgentReply>(output.send[0]).header.sequence;
  EXPECT_EQ(std::get<msg::AgentReply>(output.send[1]).header.sequence, first + 1);
  EXPECT_EQ(output.notes, std::vector<std::string>{"a word"});
  EXPECT_TRUE(output.hand_stop);
  EXPECT_EQ(output.command.linear_m_s, 0.5);
  const AgentOutput empty = bench.take();
  EXPECT_TRUE(empty.send.empty());
  EXPECT_TRUE(empty.notes.empty());
  EXPECT_FALSE(empty.hand_stop);
}

}  // namespace
}  // namespace weft::agents::test
