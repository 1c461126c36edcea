#include <gtest/gtest.h>

#include <algorithm>

#include "tests/agents/agent/rig.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;
using Kind = msg::AgentCommand::Kind;

/// Arranges a robot whose method refines.
struct RefiningRobot {
  RefiningRobot() { rig.script->refines = {"marks"}; }

  void begin(std::uint64_t number) {
    rig.tell(rig.command(Kind::teach_start, number));
    rig.run(100ms);
  }
  /// Teaches for three seconds, ten places each.
  void teach() {
    rig.run(4s);
    begin(1);
    rig.run(3s);
    rig.tell(rig.command(Kind::teach_stop, 2));
  }
  ExperienceId run() const { return rig.script->taught.front().experience; }

  static bool is_draft(const Edge& edge) {
    return edge.id.a.experience == edge.id.b.experience &&
           identical(edge.a_from_b, an_edge(edge.id.a, edge.id.b).a_from_b);
  }
  bool has_heard_drafts() const {
    return std::ranges::any_of(rig.server.heard,
                               [](const Batch& batch) { return std::ranges::any_of(batch.edges, is_draft); });
  }
  /// Expects the run once and whole at the server, with this reason, and nothing left on the disk.
  void expect_whole(bool refined, const std::string& reason) const {
    const Experience* const found = rig.server.snapshot.experience(run());
    ASSERT_NE(found, nullptr);
    EXPECT_EQ(rig.server.times_joined.at(run()), static_cast<int>(found->places.size()));
    EXPECT_EQ(found->chain.size() + 1, found->places.size());
    EXPECT_EQ(std::count_if(found->chain.begin(), found->chain.end(), is_draft),
              refined ? 0 : static_cast<std::ptrdiff_t>(found->chain.size()))
        << "all of it or nothing";
    EXPECT_TRUE(found->sealed);
    EXPECT_EQ(found->seal_reason, reason);
    EXPECT_TRUE(rig.disk->records.empty());
  }
  Rig rig;
};

struct HeldBack : testing::Test, RefiningRobot {};

constexpr const char* kUnrefined = "taught to its end, handed in before it was refined";

TEST_F(HeldBack, NothingOfADraftReachesTheServer) {
  rig.script->pieces = 30;
  teach();
  rig.run(2s);
  EXPECT_TRUE(rig.server.heard.empty());
  EXPECT_TRUE(rig.server.contents.empty()) << "nor a content";
  EXPECT_GE(rig.disk->records.size(), 6U) << "all of it is on the disk";
  rig.run(10s);
  EXPECT_FALSE(has_heard_drafts());
  expect_whole(true, "taught to its end");
  EXPECT_EQ(rig.server.snapshot.experience(run())->places.size(), rig.script->index);
}

TEST_F(HeldBack, RestartedServerGetsNothingOfItEither) {
  rig.script->pieces = 30;
  teach();
  rig.run(1s);
  rig.server.restart();
  rig.tell(rig.server.hello());
  rig.run(1s);
  EXPECT_TRUE(rig.server.heard.empty());
  rig.run(10s);
  expect_whole(true, "taught to its end");
}

TEST_F(HeldBack, CrashAtAnyMomentLosesAndDoublesNothing) {
  for (int moment = 0; moment < 40; ++moment) {
    RefiningRobot one;
    one.teach();
    one.rig.run(moment * 50ms);
    const bool was_refined = std::ranges::none_of(one.rig.disk->records, [](const auto& record) {
      return std::ranges::any_of(record.batch.edges, RefiningRobot::is_draft);
    });
    const bool was_sealed =
        std::ranges::any_of(one.rig.disk->records, [](const auto& record) { return record.batch.seal; });
    const bool was_over = one.rig.disk->records.empty();
    const ExperienceId run = one.run();
    one.rig.restart_agent();
    one.rig.script->taught.push_back({.experience = run, .robot = one.rig.robot});
    one.rig.run(20s);
    SCOPED_TRACE(moment);
    one.expect_whole(was_refined, was_refined || was_over ? "taught to its end"
                                  : was_sealed            ? kUnrefined
                                                          : "the agent was restarted while it was being taught");
    if (was_refined) {
      EXPECT_FALSE(one.has_heard_drafts());
    }
  }
}

TEST_F(HeldBack, PowerCutInTheReplacementLeavesTheDraft) {
  teach();
  rig.run(200ms);
  rig.disk->faults.tear_next = true;  // of what is written next, nothing is there
  rig.run(2s);
  EXPECT_EQ(rig.disk->faults.struck, 1U);
  rig.run(10s);
  expect_whole(false, kUnrefined);
}

TEST_F(HeldBack, ProgressIsShown) {
  rig.script->pieces = 20;
  teach();
  rig.run(1500ms);
  const auto state = rig.last<msg::RobotState>();
  EXPECT_EQ(state->mode, msg::RobotMode::idle);
  EXPECT_EQ(state->reason.rfind("refines what it was taught: ", 0), 0U) << state->reason;
  EXPECT_NE(state->reason.find(" of 20 pieces"), std::string::npos) << state->reason;
  rig.run(5s);
  EXPECT_EQ(rig.last<msg::RobotState>()->reason, "");
}

TEST_F(HeldBack, EndIsAnsweredWhenTheRefinedRunHasArrived) {
  rig.script->pieces = 200;  // 20 s
  teach();
  rig.run(18s);
  EXPECT_EQ(rig.sent<msg::AgentReply>().size(), 1U) << "of the beginning";
  rig.run(5s);
  const auto reply = rig.last<msg::AgentReply>();
  EXPECT_TRUE(reply->done);
  EXPECT_EQ(reply->reason.find("still being refined"), std::string::npos) << reply->reason;
}

TEST_F(HeldBack, EndIsAnsweredInTimeHoweverLongItTakes) {
  rig.script->pieces = 100'000;
  teach();
  rig.run(46s);
  const auto reply = rig.last<msg::AgentReply>();
  EXPECT_TRUE(reply->done);
  EXPECT_NE(reply->reason.find("still being refined"), std::string::npos) << reply->reason;
}

TEST_F(HeldBack, PlaceForALabelIsNamedAtOnceAndArrivesWithTheRun) {
  rig.run(4s);
  begin(1);
  rig.run(1s);
  rig.tell(rig.command(Kind::keep_place, 2));
  rig.run(500ms);
  const auto reply = rig.last<msg::AgentReply>();
  ASSERT_TRUE(reply->done);
  EXPECT_EQ(rig.server.snapshot.place(reply->place), nullptr) << "the server waits for it with the label";
  rig.tell(rig.command(Kind::teach_stop, 3));
  rig.run(5s);
  EXPECT_NE(rig.server.snapshot.place(reply->place), nullptr);
}

TEST_F(HeldBack, RunsOfOtherMethodsGoOn) {
  rig.script->teaches = {"plain", "marks"};
  rig.script->pieces = 40;
  teach();
  rig.run(2s);
  const TeachStart& taught = rig.script->taught.front();
  EXPECT_TRUE(rig.server.snapshot.experience(taught.experience)->sealed);
  EXPECT_EQ(rig.server.snapshot.experience(taught.others.front()), nullptr);
  rig.run(10s);
  EXPECT_TRUE(rig.server.snapshot.experience(taught.others.front())->sealed);
  EXPECT_EQ(rig.server.snapshot.stitch_count(), rig.script->index) << "with all that joins the two";
  EXPECT_TRUE(rig.disk->records.empty());
}

TEST_F(HeldBack, WhatIsJoinedToAHeldRunWaitsForIt) {
  rig.script->teaches = {"marks", "plain"};
  rig.script->pieces = 40;
  teach();
  rig.run(2s);
  EXPECT_TRUE(rig.server.heard.empty());
  rig.run(20s);
  const TeachStart& taught = rig.script->taught.front();
  EXPECT_TRUE(rig.server.snapshot.experience(taught.experience)->sealed);
  EXPECT_TRUE(rig.server.snapshot.experience(taught.others.front())->sealed);
  EXPECT_EQ(rig.server.snapshot.stitch_count(), rig.script->index);
}

TEST_F(HeldBack, NextRunMayBeTaughtMeanwhile) {
  rig.script->pieces = 30;
  teach();
  rig.run(1s);
  const std::uint32_t places = rig.script->index;
  begin(3);
  ASSERT_EQ(rig.script->taught.size(), 2U);
  rig.run(5s);
  EXPECT_TRUE(rig.server.heard.empty()) << "teaching needs every sample";
  rig.tell(rig.command(Kind::teach_stop, 4));
  rig.run(20s);
  EXPECT_EQ(rig.server.times_joined.at(run()), static_cast<int>(places));
  EXPECT_TRUE(rig.server.snapshot.experience(rig.script->taught.back().experience)->sealed);
  EXPECT_FALSE(has_heard_drafts());
  EXPECT_TRUE(rig.disk->records.empty());
}

TEST_F(HeldBack, RunThatBreaksOffIsRefinedToo) {
  rig.run(4s);
  begin(1);
  rig.run(2s);
  rig.take(rig.agent->body_failed({ErrorCode::unavailable, "no base"}, rig.now));
  rig.body = false;
  rig.run(10s);
  expect_whole(true, "teaching broke off");
}

}  // namespace
}  // namespace weft::agents::test
