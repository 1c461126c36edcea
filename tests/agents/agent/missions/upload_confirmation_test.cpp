#include "agents/agent/missions/upload_confirmation.hpp"

#include <gtest/gtest.h>

#include "tests/agents/agent/bench.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

struct ConfirmationBench : Bench {
  /// Arranges a sealed run of one place of its second method, which the server does not have.
  ConfirmationBench() {
    run.experience = ExperienceId{1};
    run.others = {ExperienceId{2}};
    Kept kept;
    kept.content = some_content(1, 50);
    kept.place = a_place(run.others.front(), 0, config.self, kept.content);
    spooler.begin(run.others.front(), "");
    EXPECT_TRUE(spooler.add(kept, now));
    EXPECT_TRUE(spooler.seal("taught to its end", now));
    confirmation.await(run, key(1), now);
  }
  void acknowledge() {
    msg::BatchAck ack;
    ack.experience = run.others.front();
    ack.durable_through = 1;
    spooler.on_ack(ack, now);
  }
  TaughtRun run;
  UploadConfirmation confirmation;
};

TEST(UploadConfirmation, WaitsForTheExperiencesOfAllMethods) {
  ConfirmationBench bench;
  bench.confirmation.tick(bench.spooler, bench.replies, bench.now);
  EXPECT_TRUE(bench.replied().empty());
  bench.acknowledge();
  bench.confirmation.tick(bench.spooler, bench.replies, bench.now);
  const msg::AgentReply reply = bench.only_reply();
  EXPECT_TRUE(reply.done);
  EXPECT_EQ(reply.experience, bench.run.experience);
  EXPECT_EQ(reply.reason, summary(bench.run));
  EXPECT_FALSE(bench.confirmation.is_awaiting());
}

TEST(UploadConfirmation, SaysAfterFifteenSecondsThatTheRestIsOnTheDisk) {
  ConfirmationBench bench;
  bench.confirmation.was_away(1s);
  EXPECT_EQ(bench.confirmation.next(), bench.now + 16s);
  bench.confirmation.tick(bench.spooler, bench.replies, bench.now + 15s);
  EXPECT_TRUE(bench.replied().empty());
  bench.confirmation.tick(bench.spooler, bench.replies, bench.now + 16s);
  const msg::AgentReply reply = bench.only_reply();
  EXPECT_TRUE(reply.done);
  EXPECT_NE(reply.reason.find("the rest is on the robot's disk"), std::string::npos);
}

TEST(UploadConfirmation, IsRefusedByARefusalOfItsOwnRunOnly) {
  ConfirmationBench bench;
  bench.confirmation.refused(ExperienceId{3}, "not this one", bench.replies);
  EXPECT_TRUE(bench.confirmation.is_awaiting());
  bench.confirmation.refused(ExperienceId{2}, "out of room", bench.replies);
  EXPECT_EQ(bench.only_reply().reason, "out of room");
  EXPECT_FALSE(bench.confirmation.next().has_value());
}

TEST(UploadConfirmation, DroppedIsNeverAnswered) {
  ConfirmationBench bench;
  bench.confirmation.drop();
  bench.acknowledge();
  bench.confirmation.tick(bench.spooler, bench.replies, bench.now + 1h);
  EXPECT_TRUE(bench.replied().empty());
}

}  // namespace
}  // namespace weft::agents::test
