#include <gtest/gtest.h>

#include "tests/contract/map_store/store_fixture.hpp"
#include "tests/storage/sample_map.hpp"

/// Checks on every engine labels that wait for a place which its robot has not handed in yet.
namespace weft::storage {
namespace {

class MapAwaitedLabels : public StoreTest {
 protected:
  void SetUp() override {
    StoreTest::SetUp();
    commit(sample::transaction(run_.next(4)));
  }
  PutAwaitedLabel awaited(const std::string& label, std::uint32_t place) const {
    return {.label = label,
            .place = {run_.experience(), place},
            .robot = sample::robot(1),
            .asker = sample::robot(7),
            .request = 0xffff'ffff'0000'0001,
            .who = "anna"};
  }

  sample::Run run_{0xffff'ffff'0000'0011, 1};
};

using Waiting = std::map<std::string, PutAwaitedLabel>;

TEST_P(MapAwaitedLabels, WaitAfterARestartAndMakeNoRevision) {
  EXPECT_EQ(commit({{awaited("dock", 6)}}), Revision{1});
  EXPECT_EQ(commit({{awaited("gate", 6)}}), Revision{1}) << "two labels of one place are two";
  EXPECT_EQ(commit({{awaited("dock", 6)}}), Revision{1}) << "one that comes again is one";
  for (int round = 0; round < 2; ++round) {
    restart();
    EXPECT_EQ(stored_.awaited_labels, (Waiting{{"dock", awaited("dock", 6)}, {"gate", awaited("gate", 6)}}));
    EXPECT_TRUE(stored_.snapshot.labels().empty());
    EXPECT_TRUE(finish(store_->check()).findings.empty());
  }
}

TEST_P(MapAwaitedLabels, WaitForTheLatestPlace) {
  commit({{awaited("dock", 6)}});
  commit({{awaited("dock", 9)}});
  restart();
  EXPECT_EQ(stored_.awaited_labels, (Waiting{{"dock", awaited("dock", 9)}}));
}

TEST_P(MapAwaitedLabels, GoInTheCommitThatSetsThem) {
  commit({{awaited("dock", 6), awaited("gate", 6)}});
  const Transaction set{{PutLabel{"dock", {run_.experience(), 6}}, PutAwaitedLabel{.label = "dock", .place = {}}}};
  EXPECT_EQ(refusal(set), ErrorCode::conflict) << "the place is not there";
  restart();
  EXPECT_EQ(stored_.awaited_labels.size(), 2U) << "a refused transaction leaves it";
  commit(sample::transaction(run_.next(4)));
  EXPECT_EQ(commit(set), Revision{3});
  restart();
  EXPECT_EQ(stored_.awaited_labels, (Waiting{{"gate", awaited("gate", 6)}}));
  EXPECT_TRUE(stored_.snapshot.labels().contains("dock"));
}

TEST_P(MapAwaitedLabels, OutliveACompaction) {
  commit({{awaited("dock", 6)}});
  commit({{TakeOut{{{{run_.experience(), 0, 3}}, {}}}}});
  EXPECT_TRUE(finish(store_->compact({2})).finished);
  restart();
  EXPECT_EQ(stored_.awaited_labels, (Waiting{{"dock", awaited("dock", 6)}}));
}

TEST_P(MapAwaitedLabels, HaveAName) {
  EXPECT_EQ(refusal({{awaited("", 6)}}), ErrorCode::invalid);
}

INSTANTIATE_TEST_SUITE_P(Engines, MapAwaitedLabels, all_engines(), engine_name);

}  // namespace
}  // namespace weft::storage
