#include "core/network/rules.hpp"

#include <gtest/gtest.h>

#include "core/network/codec.hpp"
#include "tests/contract/map_store/store_fixture.hpp"
#include "tests/storage/sample_map.hpp"

/// Checks rules on every engine, a revision each, and which robots are held, which is no revision.
namespace weft::storage {
namespace {

class MapRules : public StoreTest {
 protected:
  void SetUp() override {
    StoreTest::SetUp();
    commit(sample::transaction(run_.next(8)));
    commit({{PutLabel{"dock", {run_.experience(), 2}}}});
  }

  sample::Run run_{0x11, 1};
  Rule shut_{.name = "shut",
             .spans = {{{run_.experience(), 1}, {run_.experience(), 4}}},
             .area = Area{"hall", hash_bytes(Bytes{1}), {{0, 0}, {4, 0}, {4, 3}}}};
  Rule slow_{.name = "slow", .kind = RuleKind::speed, .value = 0.25, .label = "dock", .within_m = 3.0};
};

using Map = Snapshot::Rules;

TEST_P(MapRules, AreARevisionAndSurviveARestart) {
  EXPECT_EQ(commit({{PutRule{shut_}}}), Revision{3});
  EXPECT_EQ(commit({{PutRule{slow_}}}), Revision{4});
  Rule slower = slow_;
  slower.value = 0.125;
  EXPECT_EQ(commit({{PutRule{slower}}}), Revision{5});
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(at(5).rules(), (Map{{"shut", shut_}, {"slow", slower}}));
    EXPECT_EQ(at(4).rules(), (Map{{"shut", shut_}, {"slow", slow_}}));
    EXPECT_EQ(at(3).rules(), (Map{{"shut", shut_}}));
    EXPECT_TRUE(at(2).rules().empty());
    EXPECT_EQ(at(3, at(5)).rules(), (Map{{"shut", shut_}}));
    restart();
    EXPECT_EQ(stored_.snapshot.rules(), (Map{{"shut", shut_}, {"slow", slower}}));
    EXPECT_TRUE(finish(store_->check()).findings.empty());
  }
}

TEST_P(MapRules, AreInTheLogAndInTheChangesOfTheirRevision) {
  commit({{PutRule{shut_}}});
  commit({{PutRule{{.name = "shut"}, false}}});
  const auto log = store_->log({}, 2).value();
  EXPECT_EQ(log[1].kind, "rule");
  EXPECT_EQ(log[1].cause, "shut: " + to_string(shut_));
  EXPECT_EQ(log[0].cause, "shut goes");
  EXPECT_EQ(changes(3).rules, std::set<std::string>{"shut"});
  EXPECT_EQ(changes(4).rules, std::set<std::string>{"shut"});
  EXPECT_TRUE(changes(2).rules.empty());
  EXPECT_TRUE(at(4).rules().empty());
}

TEST_P(MapRules, AreGoneBackOverByARollback) {
  commit({{PutRule{shut_}}});
  commit({{PutRule{slow_}}});
  commit({{RollBack{{3}}}});
  EXPECT_EQ(at(5).rules(), (Map{{"shut", shut_}}));
  restart();
  EXPECT_EQ(stored_.snapshot.rules(), (Map{{"shut", shut_}}));
}

TEST_P(MapRules, StayWhateverBecomesOfTheirPlaces) {
  commit({{PutRule{shut_}}});
  commit({{TakeOut{{{{run_.experience(), 0, 7}}, {}}}}});
  EXPECT_EQ(at(4).rules(), (Map{{"shut", shut_}}));
  EXPECT_TRUE(finish(store_->compact({4})).finished);
  restart();
  EXPECT_EQ(stored_.snapshot.rules(), (Map{{"shut", shut_}}));
  EXPECT_TRUE(finish(store_->check()).findings.empty());
}

TEST_P(MapRules, AreKeptByACompactionAsFarAsAMapHasThem) {
  commit({{PutRule{shut_}}});         // 3
  commit({{PutRule{shut_, false}}});  // 4
  commit({{PutRule{shut_}}});         // 5
  commit({{PutRule{slow_}}});         // 6
  commit({{PutRule{slow_, false}}});  // 7
  EXPECT_TRUE(finish(store_->compact({6})).finished);
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(at(6).rules(), (Map{{"shut", shut_}, {"slow", slow_}}));
    EXPECT_EQ(at(7).rules(), (Map{{"shut", shut_}}));
    EXPECT_EQ(changes(7).rules, std::set<std::string>{"slow"}) << "it can still be undone";
    restart();
    EXPECT_TRUE(finish(store_->check()).findings.empty());
  }
}

TEST_P(MapRules, OfPlacesThatAreNotStoredAreRefused) {
  Rule rule = shut_;
  rule.spans[0].to.index = 8;
  EXPECT_EQ(refusal({{PutRule{rule}}}), ErrorCode::conflict);
  rule.spans[0].to = {{0x33}, 0};
  EXPECT_EQ(refusal({{PutRule{rule}}}), ErrorCode::conflict);
  rule = shut_;
  rule.name.clear();
  EXPECT_EQ(refusal({{PutRule{rule}}}), ErrorCode::invalid);
}

TEST_P(MapRules, HeldRobotsAreHeldAfterARestartAndMakeNoRevision) {
  EXPECT_EQ(commit({{PutHold{sample::robot(1), "anna"}, PutHold{sample::robot(2), "ben"}}}), Revision{2});
  restart();
  EXPECT_EQ(stored_.holds, (std::map<RobotId, std::string>{{sample::robot(1), "anna"}, {sample::robot(2), "ben"}}));
  commit({{PutHold{sample::robot(1), ""}}});
  restart();
  EXPECT_EQ(stored_.holds, (std::map<RobotId, std::string>{{sample::robot(2), "ben"}}));
}

INSTANTIATE_TEST_SUITE_P(Engines, MapRules, all_engines(), engine_name);

}  // namespace
}  // namespace weft::storage
