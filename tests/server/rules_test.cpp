#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/server/arranged_site.hpp"

/// Tests rules as operators lay them down, and robots that they hold.
namespace weft::server::test {
namespace {

using Kind = msg::OperatorRequest::Kind;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

struct ServerRules : testing::Test {
  ServerRules() {
    site.arrive(r1, std::nullopt);
    site.hand_in(r1, run.next(40));
    site.label("dock", run.place(39));
    site.hush();
  }
  msg::OperatorReply named(Kind kind, const std::string& name) {
    msg::OperatorRequest request = site.request(kind);
    request.rule.name = name;
    request.robot = name;
    return site.ask(request);
  }
  const Snapshot::Rules& rules() { return site.service().snapshot().rules(); }

  Site site;
  Peer r1{.id = robot_id(1), .name = "r1"};
  TaughtRun run{r1, 10};
  Rule shut{.name = "shut", .spans = {{run.place(20), run.place(24)}}};
};

TEST_F(ServerRules, AreLaidDownChangedRemovedAndUndone) {
  const msg::OperatorReply done = site.put_rule(shut);
  EXPECT_EQ(done.outcome, msg::Outcome::done) << done.message;
  EXPECT_THAT(done.message, HasSubstr("rule shut (closed on "));
  EXPECT_THAT(site.events_of("map.rule"), ElementsAre(HasSubstr("rule shut laid down")));
  EXPECT_THAT(site.put_rule(shut).message, HasSubstr("is so already"));
  shut.spans[0].to = run.place(30);
  EXPECT_EQ(site.put_rule(shut).outcome, msg::Outcome::done);
  EXPECT_THAT(rules(), SizeIs(1));
  site.restart();
  EXPECT_EQ(rules().at("shut"), shut);
  const msg::OperatorReply gone = named(Kind::rule_remove, "shut");
  EXPECT_EQ(gone.outcome, msg::Outcome::done) << gone.message;
  EXPECT_THAT(rules(), IsEmpty());
  EXPECT_THAT(named(Kind::rule_remove, "shut").message, HasSubstr("the map has no rule shut; it has none"));
  msg::OperatorRequest undo = site.request(Kind::undo);
  undo.work.revision = gone.revision;
  EXPECT_EQ(site.ask(undo).outcome, msg::Outcome::done);
  EXPECT_EQ(rules().at("shut"), shut);
}

TEST_F(ServerRules, ThatWouldBeLaidDownAreSaid) {
  msg::OperatorRequest request = site.request(Kind::rule_put);
  request.rule = shut;
  request.work.only_say = true;
  EXPECT_THAT(site.ask(request).message, HasSubstr("nothing was changed"));
  EXPECT_THAT(rules(), IsEmpty());
}

TEST_F(ServerRules, ThatCannotHoldAreRefused) {
  shut.spans[0].to = run.place(60);
  const msg::OperatorReply reply = site.put_rule(shut);
  EXPECT_EQ(reply.outcome, msg::Outcome::refused);
  EXPECT_THAT(reply.message, HasSubstr("is not in the map"));
}

TEST_F(ServerRules, KeepTheirArea) {
  shut.area = Area{"hall", {}, {{0, 0}, {4, 0}, {4, 3}}};
  EXPECT_EQ(site.put_rule(shut).outcome, msg::Outcome::done);
  site.restart();
  EXPECT_EQ(rules().at("shut"), shut);
  EXPECT_EQ(site.read(msg::Query::Kind::rules).rules.at(0).rule, shut);
  EXPECT_EQ(named(Kind::hold, "shut").outcome, msg::Outcome::done) << "although no plan is registered";
  EXPECT_EQ(rules().at("hold-shut").area, shut.area);
  shut.area->corners.pop_back();
  const msg::OperatorReply refused = site.put_rule(shut);
  EXPECT_EQ(refused.outcome, msg::Outcome::refused);
  EXPECT_THAT(refused.message, HasSubstr("its area on plan hall has 2 corners"));
}

TEST_F(ServerRules, ThatAnUndoWouldBringBackAreRefusedWhereTheMapHasTheMost) {
  storage::Transaction most;
  for (std::size_t i = 0; i < kMostRules; ++i) {
    most.changes.emplace_back(storage::PutRule{{.name = "rule" + std::to_string(i), .label = "dock"}});
  }
  const std::unique_ptr<storage::MapStore> store = storage::make_memory_store(site.disk);
  ASSERT_TRUE(store->open());
  ASSERT_TRUE(store->commit(most));
  site.restart();
  const Revision removed = named(Kind::rule_remove, "rule7").revision;
  ASSERT_EQ(site.put_rule(shut).outcome, msg::Outcome::done);
  const auto undo = [&] {
    msg::OperatorRequest request = site.request(Kind::undo);
    request.work.revision = removed;
    return site.ask(request);
  };
  const msg::OperatorReply refused = undo();
  EXPECT_EQ(refused.outcome, msg::Outcome::refused);
  EXPECT_THAT(refused.message, HasSubstr("the map would have 1001 rules, at most 1000: remove one"));
  EXPECT_THAT(rules(), SizeIs(kMostRules));
  ASSERT_EQ(named(Kind::rule_remove, "rule8").outcome, msg::Outcome::done);
  EXPECT_EQ(undo().outcome, msg::Outcome::done);
  EXPECT_TRUE(rules().contains("rule7"));
}

TEST_F(ServerRules, AreAnsweredWithTheirPlacesAndProblems) {
  site.put_rule(shut);
  site.put_rule({.name = "calm", .kind = RuleKind::speed, .value = 0.3, .label = "dock", .within_m = 1.0});
  msg::OperatorRequest unlabel = site.request(Kind::label_remove);
  unlabel.label = "dock";
  site.ask(unlabel);
  const msg::QueryReply reply = site.read(msg::Query::Kind::rules);
  ASSERT_THAT(reply.rules, SizeIs(2));
  EXPECT_EQ(reply.rules[0].rule.name, "calm");
  EXPECT_EQ(reply.rules[0].places, 0U);
  EXPECT_EQ(reply.rules[0].problem, "the map has no label dock");
  EXPECT_EQ(reply.rules[1].rule, shut);
  EXPECT_EQ(reply.rules[1].places, 5U);
}

TEST_F(ServerRules, HeldRobotGetsNoGoalUntilItIsLetGo) {
  site.say(site.state(r1, run.place(0)));
  EXPECT_THAT(named(Kind::hold, "r1").message, HasSubstr("weft unhold r1"));
  EXPECT_THAT(named(Kind::hold, "r1").message, HasSubstr("held already"));
  site.restart();
  site.arrive(r1, run.place(0));
  site.send_goal(1, "dock", "r1");
  site.pass(2s);
  EXPECT_FALSE(site.last<msg::RouteOrder>());
  EXPECT_EQ(named(Kind::unhold, "r1").outcome, msg::Outcome::done);
  site.pass(2s);
  EXPECT_TRUE(site.last<msg::RouteOrder>());
  EXPECT_THAT(named(Kind::unhold, "r1").message, HasSubstr("nobody holds r1"));
}

TEST_F(ServerRules, PlacesOfARuleAreHeldByName) {
  site.put_rule(shut);
  EXPECT_EQ(named(Kind::hold, "shut").outcome, msg::Outcome::done);
  EXPECT_EQ(rules().at("hold-shut").kind, RuleKind::hold);
  EXPECT_EQ(rules().at("hold-shut").spans, shut.spans);
  EXPECT_EQ(named(Kind::unhold, "shut").outcome, msg::Outcome::done);
  EXPECT_THAT(rules(), SizeIs(1));
  EXPECT_THAT(named(Kind::unhold, "shut").message, HasSubstr("nobody holds shut"));
  EXPECT_THAT(named(Kind::hold, "nowhere").message, HasSubstr("no robot and no rule nowhere"));
}

}  // namespace
}  // namespace weft::server::test
