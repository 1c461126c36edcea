#include <gtest/gtest.h>

#include "core/network/change.hpp"
#include "core/network/removal.hpp"
#include "tests/agents/agent/rig.hpp"

namespace weft::agents::test {
namespace {
using namespace std::chrono_literals;

Digest whole(const FakeServer& server) {
  return digest(make_window(server.snapshot, WindowDefinition{}));
}

TEST(WindowOfAgent, LostAndReorderedPartsEndInTheServersDigest) {
  Rig rig;
  const ExperienceId laid = rig.lay_out(70, 40);
  rig.server.parts = 4;
  Random random(3);
  rig.doubled = true;
  rig.lost_down = [&](const msg::Message&) { return random.chance(0.4); };
  rig.run(60s);
  EXPECT_EQ(rig.agent->window().places.size(), 40U);
  EXPECT_EQ(rig.last<msg::RobotState>()->window_digest, whole(rig.server));
  rig.server.snapshot = with_label(rig.server.snapshot, "dock", {laid, 3});
  rig.run(120s);
  EXPECT_EQ(rig.last<msg::RobotState>()->window_digest, whole(rig.server));
  EXPECT_EQ(rig.last<msg::RobotState>()->window_revision, rig.server.snapshot.revision());
}

TEST(WindowOfAgent, WrongDigestChangesNothingAndAFreshOneIsAskedFor) {
  Rig rig;
  rig.lay_out(70, 5);
  rig.run(1s);
  const msg::WindowRequest request = *rig.last<msg::WindowRequest>();
  msg::WindowPatch patch;
  patch.definition_id = request.definition_id;
  patch.patch.base = rig.agent->window().revision;
  patch.patch.target = Revision{patch.patch.base.value + 1};
  patch.patch.digest.bytes[0] = 1;
  rig.log.clear();
  rig.lost_down = [](const msg::Message&) { return true; };
  rig.tell(rig.server.say(patch));
  rig.run(1s);
  EXPECT_EQ(rig.agent->window().places.size(), 5U);
  EXPECT_EQ(rig.agent->counters().at("patch: digest differs"), 1U);
  ASSERT_FALSE(rig.sent<msg::WindowRequest>().empty());
  EXPECT_EQ(rig.last<msg::WindowRequest>()->held, Revision{});
}

TEST(WindowOfAgent, PatchOfAnotherRevisionIsStale) {
  Rig rig;
  rig.lay_out(70, 5);
  rig.run(1s);
  msg::WindowPatch patch;
  patch.definition_id = rig.last<msg::WindowRequest>()->definition_id;
  patch.patch.base = Revision{40};
  patch.patch.target = Revision{41};
  rig.log.clear();
  rig.tell(rig.server.say(patch));
  rig.run(500ms);
  EXPECT_EQ(rig.agent->counters().at("patch: not of the revision held"), 1U);
  ASSERT_EQ(rig.sent<msg::WindowRequest>().size(), 1U);
  EXPECT_EQ(rig.last<msg::WindowRequest>()->held, rig.server.snapshot.revision());
}

TEST(WindowOfAgent, AnswersToAnEarlierIncarnationAreIgnored) {
  Rig rig;
  rig.lay_out(70, 5);
  rig.run(1s);
  const std::uint64_t old = rig.last<msg::WindowRequest>()->definition_id;
  rig.restart_agent();
  rig.lost_down = [](const msg::Message& message) { return std::holds_alternative<msg::WindowPatch>(message); };
  rig.tell(rig.server.hello());
  msg::WindowPatch patch;
  patch.definition_id = old;
  rig.tell(rig.server.say(patch));
  EXPECT_EQ(rig.agent->counters().at("patch: of another window"), 1U);
}

TEST(WindowOfAgent, UnansweredRequestsAreRepeatedMoreAndMoreSlowly) {
  Rig rig;
  rig.connected = false;
  rig.run(60s);
  const std::size_t requests = rig.sent<msg::WindowRequest>().size();
  EXPECT_GE(requests, 8U);
  EXPECT_LE(requests, 14U);
}

TEST(WindowOfAgent, MovesWithTheBelievedPlaceWhenItIsFarFromTheCentre) {
  Rig rig;
  const ExperienceId laid = rig.lay_out(70, 60);
  rig.run(2s);
  rig.script->estimate = Estimate{{laid, 2}, Relation{}, 0.0};
  rig.run(3s);
  ASSERT_TRUE(rig.last<msg::WindowRequest>()->definition.centre.has_value());
  EXPECT_EQ(*rig.last<msg::WindowRequest>()->definition.centre, (PlaceId{laid, 2}));
  EXPECT_EQ(rig.agent->window().places.size(), 28U);
  rig.log.clear();
  rig.script->estimate->place.index = 8;
  rig.run(3s);
  EXPECT_TRUE(rig.sent<msg::WindowRequest>().empty());
  rig.script->estimate->place.index = 11;
  rig.run(3s);
  EXPECT_EQ(rig.last<msg::WindowRequest>()->definition.centre, (PlaceId{laid, 11}));
}

TEST(WindowOfAgent, IsTheWholeMapWhileTeaching) {
  Rig rig;
  const ExperienceId laid = rig.lay_out(70, 60);
  rig.run(2s);
  rig.script->estimate = Estimate{{laid, 2}, Relation{}, 0.0};
  rig.run(3s);
  ASSERT_EQ(rig.agent->window().places.size(), 28U);
  rig.tell(rig.command(msg::AgentCommand::Kind::teach_start, 1));
  rig.script->estimate->place.index = 3;
  rig.run(3s);
  EXPECT_FALSE(rig.last<msg::WindowRequest>()->definition.centre.has_value());
  EXPECT_EQ(rig.agent->window().places.size(), 60U);
}

TEST(WindowOfAgent, HoldsItsRoute) {
  Rig rig;
  const ExperienceId laid = rig.lay_out(70, 60);
  rig.run(2s);
  rig.script->estimate = Estimate{{laid, 2}, Relation{}, 0.0};
  rig.tell(rig.order(a_route(laid, 60, 1)));
  rig.run(3s);
  EXPECT_EQ(rig.agent->window().places.size(), 60U);
}

/// Arranges that the window has not followed the robot yet when the route, which was always in it, ends.
TEST(WindowOfAgent, APlaceThatIsOnlyOutOfTheWindowIsStoodOnAllTheSame) {
  Rig rig;
  const ExperienceId laid = rig.lay_out(70, 60);
  rig.run(2s);
  rig.script->estimate = Estimate{{laid, 2}, Relation{}, 0.0};
  Route route = a_route(laid, 60, 1);
  rig.tell(rig.order(route));
  rig.run(3s);
  ASSERT_EQ(rig.agent->window().places.size(), 60U);
  rig.script->estimate->place.index = 55;
  route.ended = true;
  rig.tell(rig.order(route));
  rig.run(5s);
  EXPECT_EQ(rig.script->estimate->place, (PlaceId{laid, 55}));
  EXPECT_EQ(rig.last<msg::WindowRequest>()->definition.centre, (PlaceId{laid, 55}));
  EXPECT_NE(rig.agent->window().place({laid, 55}), nullptr);
}

// The window around what was taken out is empty: what is left beside it has to be asked for.
TEST(WindowOfAgent, IsFoundAgainWhenItsCentreWasTakenOut) {
  Rig rig;
  const ExperienceId laid = rig.lay_out(70, 60);
  rig.run(2s);
  rig.script->estimate = Estimate{{laid, 10}, Relation{}, 0.0};
  rig.run(3s);
  ASSERT_EQ(rig.last<msg::WindowRequest>()->definition.centre, (PlaceId{laid, 10}));
  rig.server.snapshot = without(rig.server.snapshot, {{{laid, 5, 15}}, {}});
  rig.run(35s);
  ASSERT_TRUE(rig.script->estimate) << "places beside the gap are left to stand on";
  EXPECT_NE(rig.server.snapshot.place(rig.script->estimate->place), nullptr);
  EXPECT_NE(rig.agent->window().place(rig.script->estimate->place), nullptr);
  EXPECT_EQ(rig.last<msg::WindowRequest>()->definition.centre, rig.script->estimate->place);
  EXPECT_TRUE(rig.last<msg::WindowRequest>()->definition.route.empty());
}

TEST(WindowOfAgent, ARobotWhoseWholeSurroundingsWereTakenOutDoesNotKnowWhereItIs) {
  Rig rig;
  const ExperienceId laid = rig.lay_out(70, 60);
  rig.run(2s);
  rig.script->estimate = Estimate{{laid, 10}, Relation{}, 0.0};
  rig.run(3s);
  rig.server.snapshot = without(rig.server.snapshot, {{{laid, 0, 59}}, {}});
  rig.run(35s);
  EXPECT_FALSE(rig.script->estimate);
  EXPECT_FALSE(rig.last<msg::RobotState>()->localised);
}

}  // namespace
}  // namespace weft::agents::test
