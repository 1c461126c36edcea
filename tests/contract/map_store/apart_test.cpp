#include <gtest/gtest.h>

#include "core/network/apart.hpp"
#include "tests/contract/map_store/store_fixture.hpp"
#include "tests/storage/sample_map.hpp"

/// Tests what operators vouch to be different floors: a revision like others, on every engine.
namespace weft::storage {
namespace {

class MapAparts : public StoreTest {
 protected:
  void SetUp() override {
    StoreTest::SetUp();
    commit(sample::transaction(one_.next(8)));
    commit(sample::transaction(two_.next(8)));
  }

  sample::Run one_{0x11, 1};
  sample::Run two_{0x22, 2};
  Apart low_{{one_.experience(), 0, 3}, {two_.experience(), 0, 3}};
  Apart high_{{one_.experience(), 4, 7}, {two_.experience(), 5, 5}};
};

using List = Snapshot::Aparts;

TEST_P(MapAparts, AreARevisionAndSurviveARestart) {
  EXPECT_EQ(commit({{PutApart{low_}}}), Revision{3});
  EXPECT_EQ(commit({{PutApart{{high_.other, high_.one}}}}), Revision{4}) << "in either order";
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(at(4).aparts(), (List{low_, high_}));
    EXPECT_EQ(at(3).aparts(), List{low_});
    EXPECT_TRUE(at(2).aparts().empty());
    EXPECT_EQ(at(3, at(4)).aparts(), List{low_});
    EXPECT_EQ(at(4, at(2)).aparts(), (List{low_, high_}));
    restart();
    EXPECT_EQ(stored_.snapshot.aparts(), (List{low_, high_}));
  }
  EXPECT_TRUE(are_apart(stored_.snapshot, {two_.experience(), 5}, {one_.experience(), 6}));
}

TEST_P(MapAparts, AreInTheLogAndInTheChangesOfTheirRevision) {
  commit({{PutApart{low_}}});
  commit({{PutApart{low_, false}}});
  const auto log = store_->log({}, 2).value();
  EXPECT_EQ(log[1].kind, "apart");
  EXPECT_EQ(log[1].cause, to_string(low_));
  EXPECT_EQ(log[0].cause, to_string(low_) + " are so no longer");
  EXPECT_EQ(changes(3).aparts, std::set<Apart>{low_});
  EXPECT_EQ(changes(4).aparts, std::set<Apart>{low_});
  EXPECT_TRUE(changes(2).aparts.empty());
  EXPECT_TRUE(at(4).aparts().empty());
}

TEST_P(MapAparts, AreGoneBackOverByARollback) {
  commit({{PutApart{low_}}});
  commit({{PutApart{high_}}});
  commit({{RollBack{{3}}}});
  EXPECT_EQ(at(5).aparts(), List{low_});
  commit({{RollBack{{4}}}});
  restart();
  EXPECT_EQ(stored_.snapshot.aparts(), (List{low_, high_}));
}

TEST_P(MapAparts, WaitForPlacesThatAreOut) {
  commit({{PutApart{low_}, PutApart{high_}}});
  const Removal all{{{two_.experience(), 5, 5}}, {}};
  commit({{TakeOut{all}}});
  EXPECT_EQ(at(4).aparts(), List{low_}) << "nothing of a stretch is there any more";
  EXPECT_EQ(without(at(3), all).aparts(), List{low_});
  commit({{TakeOut{{{{two_.experience(), 0, 2}}, {}}}}});
  EXPECT_EQ(at(5).aparts(), List{low_}) << "place 3 is there";
  commit({{BringBack{all}}});
  restart();
  EXPECT_EQ(stored_.snapshot.aparts(), (List{low_, high_}));
}

TEST_P(MapAparts, AreKeptByACompactionAsFarAsAMapHasThem) {
  commit({{PutApart{low_}}});                              // 3
  commit({{PutApart{low_, false}}});                       // 4
  commit({{PutApart{low_}}});                              // 5
  commit({{PutApart{high_}}});                             // 6
  commit({{PutApart{high_, false}}});                      // 7
  commit({{TakeOut{{{{one_.experience(), 0, 0}}, {}}}}});  // 8
  EXPECT_TRUE(finish(store_->compact({6})).finished);
  for (int round = 0; round < 2; ++round) {
    EXPECT_EQ(at(6).aparts(), (List{low_, high_}));
    EXPECT_EQ(at(8).aparts(), List{low_});
    EXPECT_EQ(changes(7).aparts, std::set<Apart>{high_}) << "it can still be undone";
    restart();
    EXPECT_EQ(stored_.snapshot.aparts(), List{low_});
    EXPECT_TRUE(finish(store_->check()).findings.empty());
  }
}

TEST_P(MapAparts, GoWithPlacesThatAreDeletedForGood) {
  commit({{PutApart{low_}, PutApart{high_}}});
  commit({{TakeOut{{{{two_.experience(), 0, 3}}, {}}}}});
  EXPECT_TRUE(finish(store_->compact({4})).finished);
  restart();
  EXPECT_EQ(stored_.snapshot.aparts(), List{high_});
  EXPECT_TRUE(finish(store_->check()).findings.empty());
}

TEST_P(MapAparts, OfPlacesThatAreNotStoredAreRefused) {
  EXPECT_EQ(refusal({{PutApart{{{one_.experience(), 0, 8}, low_.other}}}}), ErrorCode::conflict);
  EXPECT_EQ(refusal({{PutApart{{low_.one, {{0x33}, 0, 1}}}}}), ErrorCode::conflict);
  EXPECT_EQ(refusal({{PutApart{{{one_.experience(), 3, 0}, low_.other}}}}), ErrorCode::conflict);
}

INSTANTIATE_TEST_SUITE_P(Engines, MapAparts, all_engines(), engine_name);

}  // namespace
}  // namespace weft::storage
