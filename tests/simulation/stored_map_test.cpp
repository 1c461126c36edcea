#include "tests/simulation/stored_map.hpp"

#include <gtest/gtest.h>

#include "core/network/search.hpp"

namespace weft::simulation {
namespace {

class StoredMaps : public testing::Test {
 protected:
  Site site = make_large_site(4, Random(1));
  StoredMap map{site, 4, teacher(), Random(2)};

  static RobotId teacher() {
    RobotId id;
    id.bytes[0] = 1;
    return id;
  }
};

TEST_F(StoredMaps, IsWhatAServerTakesFromARobot) {
  Snapshot snapshot;
  for (const Batch& batch : map.batches()) {
    for (const Error& error : check(snapshot, batch)) ADD_FAILURE() << error.message;
    snapshot = with(snapshot, batch);
  }
  EXPECT_EQ(snapshot.place_count(), map.places().size());
  EXPECT_EQ(map.labels().size(), site.stations() + 4);
}

TEST_F(StoredMaps, LeadsFromOneStartToEveryLabelAndBack) {
  Snapshot snapshot;
  for (const Batch& batch : map.batches()) snapshot = with(snapshot, batch);
  const PlaceId& start = map.labels().at("start-0");
  for (const auto& [label, place] : map.labels()) {
    if (label == "start-0") continue;
    const auto there = shortest_path(snapshot, start, place, {"marks"});
    const auto back = shortest_path(snapshot, place, start, {"marks"});
    ASSERT_TRUE(there) << label << ": " << there.error().message;
    ASSERT_TRUE(back) << label << ": " << back.error().message;
    EXPECT_LT(there->places.size() + back->places.size(), 700U) << label;
  }
}

TEST_F(StoredMaps, IsThereWhenTheStoreIsOpenedAgain) {
  const auto disk = std::make_shared<storage::MemoryDisk>();
  ASSERT_TRUE(map.write(disk));
  const auto store = storage::make_memory_store(disk);
  const auto stored = store->open();
  ASSERT_TRUE(stored) << stored.error().message;
  EXPECT_EQ(stored->snapshot.place_count(), map.places().size());
  EXPECT_EQ(stored->snapshot.labels().size(), map.labels().size());
}

}  // namespace
}  // namespace weft::simulation
