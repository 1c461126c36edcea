#include <gtest/gtest.h>

#include <utility>

#include "agents/agent/missions/taught_run.hpp"
#include "tests/agents/agent/rig.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;
using Kind = msg::AgentCommand::Kind;

/// Begins to teach by hand, with no place kept but those that are asked for.
void begin_sparingly(Rig& rig) {
  rig.script->keep_each_step = false;
  rig.run(4s);
  rig.tell(rig.command(Kind::teach_start, 1));
  rig.run(1s);
}

TEST(Teaching, AlongAFileStartsTheHandAndAnswersWithItsWord) {
  Rig rig;
  rig.run(4s);
  msg::AgentCommand command = rig.command(Kind::teach_start, 1);
  command.along = {{0.0, 0.0}, {3.0, 0.0}};
  rig.tell(command);
  EXPECT_EQ(rig.hand_starts, 1);
  EXPECT_EQ(rig.hand.size(), 2U);
  EXPECT_TRUE(rig.script->taught.empty());
  rig.take(rig.agent->hand_answered(fail(ErrorCode::invalid, "the second point is in rack A"), rig.now));
  ASSERT_TRUE(rig.last<msg::AgentReply>().has_value());
  EXPECT_FALSE(rig.last<msg::AgentReply>()->done);
  EXPECT_EQ(rig.last<msg::AgentReply>()->reason, "the second point is in rack A");
  command.command = 2;
  rig.tell(command);
  rig.take(rig.agent->hand_answered({}, rig.now));
  EXPECT_EQ(rig.script->taught.size(), 1U);
  EXPECT_TRUE(rig.last<msg::AgentReply>()->done);
  EXPECT_EQ(rig.last<msg::AgentReply>()->experience, rig.script->taught.front().experience);
}

TEST(Teaching, BodyWithoutAHandRefusesAFile) {
  Rig rig;
  rig.config.can_be_taught_along = false;
  rig.config.body = "replay";
  rig.restart_agent();
  rig.run(4s);
  msg::AgentCommand command = rig.command(Kind::teach_start, 1);
  command.along = {{0.0, 0.0}, {3.0, 0.0}};
  rig.tell(command);
  EXPECT_FALSE(rig.last<msg::AgentReply>()->done);
  EXPECT_NE(rig.last<msg::AgentReply>()->reason.find("replay"), std::string::npos);
}

TEST(Teaching, HandDoneIsShown) {
  Rig rig;
  rig.run(4s);
  rig.tell(rig.command(Kind::teach_start, 1));
  rig.sample.hand = true;
  rig.run(1s);
  EXPECT_EQ(rig.last<msg::RobotState>()->mode, msg::RobotMode::teaching);
  EXPECT_EQ(rig.last<msg::RobotState>()->reason, "");
  rig.sample.hand_done = true;
  rig.run(1s);
  EXPECT_EQ(rig.last<msg::RobotState>()->reason, "hand_done");
}

TEST(Teaching, SeedWaitsForItsMapAndThenLooksThere) {
  Rig rig;
  const ExperienceId laid = rig.lay_out(70, 10);
  rig.lost_down = [](const msg::Message& message) { return std::holds_alternative<msg::Chunk>(message); };
  rig.run(4s);
  msg::AgentCommand command = rig.command(Kind::teach_start, 1);
  command.seed = PlaceId{laid, 4};
  rig.tell(command);
  rig.run(3s);
  EXPECT_TRUE(rig.script->taught.empty());
  rig.lost_down = [](const msg::Message&) { return false; };
  rig.run(10s);
  EXPECT_TRUE(rig.script->taught.empty());
  EXPECT_EQ(rig.script->sought.back(), (PlaceId{laid, 4}));
  rig.script->answer.fix = Fix{{laid, 4}, Relation{}, {}};
  rig.run(1s);
  EXPECT_EQ(rig.script->taught.size(), 1U);
}

TEST(Teaching, SeedThatIsNotFoundIsRefused) {
  Rig rig;
  const ExperienceId laid = rig.lay_out(70, 10);
  rig.run(4s);
  msg::AgentCommand command = rig.command(Kind::teach_start, 1);
  command.seed = PlaceId{laid, 4};
  rig.tell(command);
  rig.run(70s);
  ASSERT_TRUE(rig.last<msg::AgentReply>().has_value());
  EXPECT_NE(rig.last<msg::AgentReply>()->reason.find("did not find itself"), std::string::npos);
  ASSERT_FALSE(rig.script->sought.empty());
  EXPECT_FALSE(rig.script->sought.back()) << "without a seed it looks elsewhere, too";
  EXPECT_TRUE(rig.script->taught.empty());
}

TEST(Teaching, SeedThatIsNowhereIsRefused) {
  Rig rig;
  rig.run(4s);
  msg::AgentCommand command = rig.command(Kind::teach_start, 1);
  command.seed = PlaceId{ExperienceId{5}, 4};
  rig.tell(command);
  rig.run(25s);
  ASSERT_TRUE(rig.last<msg::AgentReply>().has_value());
  EXPECT_FALSE(rig.last<msg::AgentReply>()->done);
  EXPECT_EQ(rig.last<msg::RobotState>()->mode, msg::RobotMode::idle);
}

TEST(Teaching, LabelHereKeepsAPlaceAndAnswersOnceItIsOnDisk) {
  Rig rig;
  begin_sparingly(rig);
  rig.tell(rig.command(Kind::keep_place, 2));
  EXPECT_EQ(rig.sent<msg::AgentReply>().size(), 1U);
  std::uint64_t on_disk = 0;
  rig.lost_up = [&](const msg::Message& message) {
    if (std::holds_alternative<msg::AgentReply>(message)) on_disk = rig.disk->records.size();
    return false;
  };
  rig.connected = false;
  rig.run(200ms);
  ASSERT_EQ(rig.sent<msg::AgentReply>().size(), 2U);
  EXPECT_TRUE(rig.last<msg::AgentReply>()->done);
  EXPECT_EQ(rig.last<msg::AgentReply>()->place, (PlaceId{rig.script->taught.front().experience, 0}));
  EXPECT_EQ(rig.disk->records.size(), 1U);
}

TEST(Teaching, LabelHereWithNothingToSeeIsRefused) {
  Rig rig;
  rig.sample.views.clear();
  rig.run(4s);
  rig.tell(rig.command(Kind::teach_start, 1));
  rig.tell(rig.command(Kind::keep_place, 2));
  rig.run(20s);
  EXPECT_FALSE(rig.last<msg::AgentReply>()->done);
  EXPECT_NE(rig.last<msg::AgentReply>()->reason.find("worth keeping"), std::string::npos);
}

TEST(Teaching, StopTakesTheLastViewAndSeals) {
  Rig rig;
  begin_sparingly(rig);
  rig.tell(rig.command(Kind::teach_stop, 2));
  EXPECT_EQ(rig.hand_stops, 1);
  EXPECT_EQ(rig.sent<msg::AgentReply>().size(), 1U);
  rig.run(500ms);
  EXPECT_TRUE(rig.last<msg::AgentReply>()->done);
  rig.run(3s);
  EXPECT_EQ(rig.server.sealed.size(), 1U);
  EXPECT_EQ(rig.script->index, 1U);
}

TEST(Teaching, StopWaitsForTheViewOfTheLastPlace) {
  Rig rig;
  begin_sparingly(rig);
  const std::vector<View> views = std::exchange(rig.sample.views, {});
  rig.run(200ms);
  rig.tell(rig.command(Kind::teach_stop, 2));
  rig.run(500ms);
  EXPECT_TRUE(rig.script->teaching) << "nothing was seen since";
  rig.sample.views = views;
  rig.run(3s);
  EXPECT_EQ(rig.script->index, 1U);
  EXPECT_EQ(rig.server.sealed.size(), 1U);
}

TEST(Teaching, WhoeverHasTaughtIsToldWhetherItIsJoined) {
  TaughtRun run;
  run.experience = ExperienceId{7};
  run.others = {ExperienceId{8}};
  const auto stitch = [](std::uint64_t a, std::uint64_t b) {
    Edge edge = an_edge({ExperienceId{a}, 1}, {ExperienceId{b}, 20});
    edge.origin = Origin::stitch;
    edge.inliers = 20;
    return edge;
  };
  EXPECT_TRUE(run.joins(stitch(3, 7)));
  EXPECT_TRUE(run.joins(stitch(7, 7))) << "a loop";
  EXPECT_FALSE(run.joins(stitch(7, 8))) << "two cameras at one place";
  Edge shortcut = stitch(7, 7);
  shortcut.inliers = 0;
  EXPECT_FALSE(run.joins(shortcut)) << "nothing was recognised";
  Edge hop = stitch(7, 7);
  hop.origin = Origin::odometry;
  EXPECT_FALSE(run.joins(hop));
  Edge across = stitch(3, 7);
  across.drivable = Drivable::none;
  EXPECT_FALSE(run.joins(across)) << "no robot can follow it";
}

TEST(Teaching, StopSaysHowManyPlacesAreJoined) {
  Rig rig;
  const ExperienceId laid = rig.lay_out(70, 2);
  begin_sparingly(rig);
  for (const std::uint32_t at : {0U, 1U}) {
    rig.script->joined_to = PlaceId{laid, at};
    rig.tell(rig.command(Kind::keep_place, 2 + at));
    rig.run(1s);
  }
  rig.tell(rig.command(Kind::teach_stop, 4));
  rig.run(3s);
  EXPECT_EQ(rig.last<msg::AgentReply>()->reason,
            "3 places, 2 joined to what was taught before, or to its own beginning");
}

TEST(Teaching, WhatWasHeldBackIsHandedInWithTheSeal) {
  Rig rig;
  const ExperienceId laid = rig.lay_out(70, 2);
  begin_sparingly(rig);
  rig.tell(rig.command(Kind::keep_place, 2));
  rig.run(3s);  // the places are with the server
  const ExperienceId taught = rig.script->taught.front().experience;
  Edge held = an_edge({laid, 1}, {taught, 0});
  held.origin = Origin::stitch;
  rig.script->held = {held};
  rig.tell(rig.command(Kind::teach_stop, 4));
  rig.run(3s);
  EXPECT_NE(rig.last<msg::AgentReply>()->reason.find("1 joined"), std::string::npos)
      << rig.last<msg::AgentReply>()->reason;
  const Experience* const known = rig.server.snapshot.experience(taught);
  ASSERT_NE(known, nullptr);
  EXPECT_TRUE(known->sealed);
  ASSERT_EQ(known->stitches.size(), 1U);
  for (const Edge& edge : known->stitches) EXPECT_EQ(edge.id, held.id);
}

TEST(Teaching, StopIsAnsweredWhenTheMapHasAllOfIt) {
  Rig rig;
  rig.run(4s);
  rig.tell(rig.command(Kind::teach_start, 1));
  rig.run(1s);
  rig.server.acknowledges = false;
  rig.tell(rig.command(Kind::teach_stop, 2));
  rig.run(3s);
  EXPECT_EQ(rig.sent<msg::AgentReply>().size(), 1U);
  rig.server.acknowledges = true;
  rig.run(10s);
  EXPECT_EQ(rig.sent<msg::AgentReply>().size(), 2U);
  const std::string said = rig.last<msg::AgentReply>()->reason;
  EXPECT_EQ(said.substr(said.find(" places")),
            " places, none joined to what was taught before, nor to its own beginning, in a way that can be driven");
  EXPECT_EQ(std::stoul(said), rig.script->index);
}

TEST(Teaching, AnotherLineOfTheSameRunMovesTheHandOn) {
  Rig rig;
  rig.run(4s);
  msg::AgentCommand command = rig.command(Kind::teach_start, 1);
  command.name = "loop";
  command.along = {{0.0, 0.0}, {3.0, 0.0}};
  rig.tell(command);
  rig.take(rig.agent->hand_answered({}, rig.now));
  rig.sample.hand_done = true;
  rig.run(1s);
  EXPECT_EQ(rig.last<msg::RobotState>()->reason, "hand_done");
  msg::AgentCommand next = rig.command(Kind::teach_start, 2);
  next.name = "loop";
  next.along = {{3.0, 0.0}, {3.0, 4.0}};
  rig.tell(next);
  EXPECT_EQ(rig.hand_starts, 2);
  EXPECT_EQ(rig.sent<msg::AgentReply>().size(), 1U);
  rig.take(rig.agent->hand_answered({}, rig.now));
  EXPECT_EQ(rig.last<msg::RobotState>()->reason, "");
  ASSERT_EQ(rig.sent<msg::AgentReply>().size(), 2U);
  EXPECT_EQ(rig.last<msg::AgentReply>()->experience, rig.script->taught.front().experience);
  EXPECT_EQ(rig.script->taught.size(), 1U);
}

TEST(Teaching, NothingTaughtLeavesNoTrace) {
  Rig rig;
  rig.sample.views.clear();
  rig.run(4s);
  rig.tell(rig.command(Kind::teach_start, 1));
  rig.run(1s);
  rig.tell(rig.command(Kind::teach_stop, 2));
  rig.run(5s);
  EXPECT_TRUE(rig.last<msg::AgentReply>()->done);
  EXPECT_TRUE(rig.sent<msg::ExperienceBatch>().empty());
}

TEST(Teaching, RobotWithAGoalIsNotTaught) {
  Rig rig;
  const ExperienceId laid = rig.lay_out(70, 10);
  rig.script->estimate = Estimate{{laid, 3}, Relation{}, 0.0};
  rig.run(4s);
  rig.tell(rig.order(a_route(laid, 10, 1)));
  rig.tell(rig.command(Kind::teach_start, 1));
  EXPECT_FALSE(rig.last<msg::AgentReply>()->done);
  EXPECT_TRUE(rig.script->taught.empty());
}

TEST(Teaching, RepeatedAfterAServersRestartIsTheSameTeaching) {
  Rig rig;
  rig.run(4s);
  msg::AgentCommand command = rig.command(Kind::teach_start, 1);
  command.name = "loop";
  rig.tell(command);
  rig.run(1s);
  rig.server.restart();
  rig.tell(rig.server.hello());
  msg::AgentCommand again = rig.command(Kind::teach_start, 5);
  again.name = "loop";
  rig.tell(again);
  EXPECT_TRUE(rig.last<msg::AgentReply>()->done);
  EXPECT_EQ(rig.last<msg::AgentReply>()->experience, rig.script->taught.front().experience);
  EXPECT_EQ(rig.script->taught.size(), 1U);
}

}  // namespace
}  // namespace weft::agents::test
