#include <gtest/gtest.h>

#include <numbers>

#include "tests/agents/agent/rig.hpp"

/// Tests `map label here` of a robot that is not being taught.
namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;
using Kind = msg::AgentCommand::Kind;

Relation ahead(double metres, double turned_degrees = 0.0) {
  return Metric2{Pose2{metres, 0.0, turned_degrees * std::numbers::pi / 180.0}, Eigen::Matrix3d::Zero()};
}

class KeepAlone : public testing::Test {
 protected:
  void SetUp() override {
    laid = rig.lay_out(70, 10);
    rig.run(4s);
  }
  void stands(double metres, double turned_degrees = 0.0) {
    rig.script->estimate = Estimate{{laid, 3}, ahead(metres, turned_degrees), 0.0};
  }
  void can_be_joined() { rig.script->joins = std::vector<Edge>{an_edge({laid, 3}, {})}; }
  msg::AgentReply last_reply() const { return rig.last<msg::AgentReply>().value_or(msg::AgentReply{}); }

  Rig rig;
  ExperienceId laid;
};

TEST_F(KeepAlone, ARobotThatDoesNotKnowWhereItIsRefuses) {
  rig.tell(rig.command(Kind::keep_place, 1));
  EXPECT_NE(last_reply().reason.find("does not know where it is"), std::string::npos);
}

TEST_F(KeepAlone, OnAPlaceThatPlaceIsMeant) {
  stands(0.03, 2.0);
  rig.tell(rig.command(Kind::keep_place, 1));
  EXPECT_TRUE(last_reply().done);
  EXPECT_EQ(last_reply().place, (PlaceId{laid, 3}));
}

TEST_F(KeepAlone, BetweenPlacesOneIsMadeThatHangsOnTheMap) {
  stands(0.2);
  can_be_joined();
  msg::AgentCommand command = rig.command(Kind::keep_place, 1);
  command.name = "dock-3";
  rig.tell(command);
  rig.run(3s);
  ASSERT_TRUE(last_reply().done) << last_reply().reason;
  const PlaceId made = last_reply().place;
  EXPECT_NE(made.experience, laid);
  EXPECT_EQ(made.index, 0U);
  EXPECT_EQ(rig.server.sealed, std::vector<ExperienceId>{made.experience});
  EXPECT_EQ(rig.server.durable_through[made.experience], 1U);
  EXPECT_EQ(rig.last<msg::RobotState>()->mode, msg::RobotMode::idle);
  for (const msg::ExperienceBatch& message : rig.sent<msg::ExperienceBatch>()) {
    const Batch& batch = message.batch;
    if (batch.experience != made.experience) continue;
    EXPECT_EQ(batch.name, "dock-3");
    ASSERT_EQ(batch.edges.size(), 1U);
    EXPECT_EQ(batch.edges[0].id, (EdgeId{{laid, 3}, made}));
  }
}

TEST_F(KeepAlone, ItIsOnTheRobotsDiskBeforeTheAnswer) {
  stands(0.2);
  can_be_joined();
  std::size_t on_disk = 0;
  rig.lost_up = [&](const msg::Message& message) {
    if (std::holds_alternative<msg::AgentReply>(message)) on_disk = rig.disk->records.size();
    return std::holds_alternative<msg::ExperienceBatch>(message);
  };
  rig.tell(rig.command(Kind::keep_place, 1));
  rig.run(1s);
  ASSERT_TRUE(last_reply().done);
  EXPECT_GE(on_disk, 1U);
}

TEST_F(KeepAlone, WhatJoinsNothingIsRefusedAndLeavesNoTrace) {
  stands(0.2);
  rig.tell(rig.command(Kind::keep_place, 1));
  rig.run(10s);
  EXPECT_TRUE(rig.sent<msg::AgentReply>().empty());
  rig.run(10s);
  EXPECT_FALSE(last_reply().done);
  EXPECT_NE(last_reply().reason.find("0.20 m"), std::string::npos) << last_reply().reason;
  EXPECT_NE(last_reply().reason.find("few_inliers"), std::string::npos) << last_reply().reason;
  EXPECT_TRUE(rig.disk->records.empty());
}

TEST_F(KeepAlone, ALaterViewMayDo) {
  stands(0.2);
  rig.tell(rig.command(Kind::keep_place, 1));
  rig.run(5s);
  can_be_joined();
  rig.run(1s);
  EXPECT_TRUE(last_reply().done) << last_reply().reason;
}

TEST_F(KeepAlone, WithoutAnyImageTheReasonSaysSo) {
  rig.sample.views.clear();
  stands(0.2);
  can_be_joined();
  rig.tell(rig.command(Kind::keep_place, 1));
  rig.run(20s);
  EXPECT_FALSE(last_reply().done);
  EXPECT_NE(last_reply().reason.find("no image came"), std::string::npos) << last_reply().reason;
}

}  // namespace
}  // namespace weft::agents::test
