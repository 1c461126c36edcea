#include <gtest/gtest.h>

#include "core/network/codec.hpp"
#include "storage/clouds/cloud.hpp"
#include "storage/sqlite/database.hpp"
#include "storage/sqlite/sqlite_store.hpp"
#include "tests/storage/sample_map.hpp"
#include "tests/storage/temporary_directory.hpp"

namespace weft::storage {
namespace {

/// Arranges a small store on disk, stopped, damaged by SQL, and started again.
class SqliteDamage : public testing::Test {
 protected:
  void SetUp() override {
    start();
    first_ = run_.next(4);
    second_ = other_.next(3);
    second_.batch.edges.push_back(sample::stitch({run_.experience(), 3}, {other_.experience(), 1}));
    for (const auto* delivery : {&first_, &second_}) ASSERT_TRUE(store_->commit(sample::transaction(*delivery)));
    const PlaceId last{run_.experience(), 3};
    ASSERT_TRUE(store_->commit(
        {{PutLabel{"far", last}, PutLabel{"near", {run_.experience(), 0}}, PutGoal{sample::goal(1, last)},
          PutGoal{sample::goal(2, last)}, PutRoute{sample::route(1, last, last)},
          PutOccupancy{sample::robot(1), sample::route(1, last, last), 0, 0}}}));
  }

  void start() {
    auto started = open_sqlite(directory_.path());
    ASSERT_TRUE(started) << started.error().message;
    store_ = std::move(*started);
    auto stored = store_->open();
    ASSERT_TRUE(stored) << stored.error().message;
    stored_ = std::move(*stored);
  }

  void damage(const std::string& sql) {
    store_.reset();
    {
      const auto database = sqlite::Database::open(directory_.path() / "map.sqlite", "");
      ASSERT_TRUE(database);
      const auto done = database->run(sql);
      ASSERT_TRUE(done) << done.error().message;
      ASSERT_GT(database->number("SELECT changes()").value(), 0U) << sql;
    }
    start();
  }

  bool is_named(const std::string& what) const {
    for (const std::string& line : stored_.quarantined) {
      if (line.find(what) != std::string::npos) return true;
    }
    return false;
  }

  TemporaryDirectory directory_;
  sample::Run run_{0x11, 1};
  sample::Run other_{0x22, 2};
  sample::Delivery first_;
  sample::Delivery second_;
  std::unique_ptr<MapStore> store_;
  Stored stored_;
};

TEST_F(SqliteDamage, DamagedContentIsQuarantinedNamedAndTheRestServed) {
  const ContentHash hash = first_.batch.places[1].content.hash;
  damage("UPDATE content SET bytes = substr(bytes, 1, 20) || x'ff' || substr(bytes, 22) WHERE hash = x'" +
         to_string(hash) + "'");
  EXPECT_TRUE(stored_.quarantined.empty()) << "contents are checked when they are read";
  const auto read = store_->content(hash);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::corrupt);
  EXPECT_NE(read.error().message.find(to_string(hash)), std::string::npos) << read.error().message;
  EXPECT_FALSE(store_->has_content(hash));
  EXPECT_EQ(store_->size().contents, 6U);
  const auto again = store_->content(hash);
  ASSERT_FALSE(again);
  EXPECT_EQ(again.error().code, ErrorCode::corrupt);
  const auto other = store_->content(first_.batch.places[2].content.hash);
  ASSERT_TRUE(other) << other.error().message;
  EXPECT_EQ(*other, first_.contents[2]);

  store_.reset();
  start();
  EXPECT_TRUE(is_named("content " + to_string(hash)));
  EXPECT_EQ(stored_.snapshot.place_count(), 7U) << "its place is still served";
  EXPECT_FALSE(store_->has_content(hash));
}

/// Tests that damage anywhere in a content's row is found by reading it as it is kept, without expanding it.
TEST_F(SqliteDamage, AStoredContentIsFoundDamagedAtItsFirstReading) {
  const std::vector<std::string> damages = {"bytes = substr(bytes, 1, 20) || x'ff' || substr(bytes, 22)",
                                            "bytes = substr(bytes, 1, length(bytes) - 1)",
                                            "bytes = x''",
                                            "size = size + 1",
                                            "size = size | (1 << 40)",
                                            "coding = 1 - coding",
                                            "coding = 2",
                                            "coding = coding + 256",
                                            "sum = sum + 1",
                                            "sum = 'seven'"};
  for (const std::string& what : damages) {
    const ContentHash hash = first_.batch.places[1].content.hash;
    ASSERT_TRUE(store_->stored_content(hash)) << what;
    damage("UPDATE content SET " + what + " WHERE hash = x'" + to_string(hash) + "'");
    EXPECT_TRUE(stored_.quarantined.empty()) << what;
    const auto read = store_->stored_content(hash);
    ASSERT_FALSE(read) << what;
    EXPECT_EQ(read.error().code, ErrorCode::corrupt) << what;
    EXPECT_NE(read.error().message.find(to_string(hash)), std::string::npos) << read.error().message;
    EXPECT_FALSE(store_->has_content(hash)) << what;
    EXPECT_EQ(store_->size().contents, 6U);
    EXPECT_EQ(store_->stored_content(first_.batch.places[2].content.hash)->size, first_.contents[2].size());
    store_.reset();
    start();
    EXPECT_TRUE(is_named("content " + to_string(hash))) << what;
    ASSERT_TRUE(store_->commit({{PutContent{hash, msg::ContentKind::content, first_.contents[1]}}}));
  }
}

TEST_F(SqliteDamage, AContentOfASchemaWithoutSumsIsVerifiedByItsHash) {
  const ContentHash good = first_.batch.places[1].content.hash;
  const ContentHash bad = first_.batch.places[2].content.hash;
  damage("UPDATE content SET sum = NULL");
  EXPECT_EQ(store_->stored_content(good)->size, first_.contents[1].size());
  damage("UPDATE content SET bytes = substr(bytes, 1, 20) || x'ff' || substr(bytes, 22) WHERE hash = x'" +
         to_string(bad) + "'");
  EXPECT_TRUE(store_->stored_content(good));
  EXPECT_EQ(store_->stored_content(bad).error().code, ErrorCode::corrupt);
  EXPECT_FALSE(store_->has_content(bad));
}

TEST_F(SqliteDamage, QuarantinedContentIsHealedWhenItComesAgain) {
  const ContentHash hash = first_.batch.places[1].content.hash;
  damage("UPDATE content SET bytes = x'00', coding = 1 WHERE hash = x'" + to_string(hash) + "'");
  ASSERT_FALSE(store_->content(hash));
  const auto committed = store_->commit({{PutContent{hash, msg::ContentKind::content, first_.contents[1]}}});
  ASSERT_TRUE(committed) << committed.error().message;
  const auto read = store_->content(hash);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_EQ(*read, first_.contents[1]);
  EXPECT_EQ(store_->size().contents, 7U);
  store_.reset();
  start();
  EXPECT_TRUE(stored_.quarantined.empty());
}

TEST_F(SqliteDamage, ACompressedCloudIsCheckedLikeAnyContent) {
  Random random(3);
  clouds::Cloud cloud;
  for (int point = 0; point < 3000; ++point) {
    cloud.points.emplace_back(static_cast<float>(random.uniform()), static_cast<float>(random.uniform()), 0.0F);
  }
  const Bytes bytes = clouds::canonical_bytes(cloud, clouds::kFineQuantum_um).value();
  const ContentHash hash = hash_bytes(bytes);
  ASSERT_TRUE(store_->commit({{PutContent{hash, msg::ContentKind::cloud, bytes}}}));
  damage("UPDATE content SET bytes = bytes WHERE coding = 2 AND length(bytes) < size / 3");
  EXPECT_EQ(store_->content(hash).value(), bytes);
  damage("UPDATE content SET bytes = substr(bytes, 1, 300) || x'ff01' || substr(bytes, 303) WHERE coding = 2");
  EXPECT_EQ(store_->content(hash).error().code, ErrorCode::corrupt);
  EXPECT_FALSE(store_->has_content(hash));
}

TEST_F(SqliteDamage, ImpossibleSizeIsCorruptNotAnAllocation) {
  const ContentHash hash = first_.batch.places[0].content.hash;
  damage("UPDATE content SET size = 4611686018427387904 WHERE hash = x'" + to_string(hash) + "'");
  const auto read = store_->content(hash);
  ASSERT_FALSE(read);
  EXPECT_EQ(read.error().code, ErrorCode::corrupt);
}

TEST_F(SqliteDamage, DamagedPlaceIsLeftOutAndTheRestIsServed) {
  damage("UPDATE place SET row = substr(row, 1, 30) || x'5a' || substr(row, 32) WHERE experience = 17 AND place = 2");
  const Experience& experience = *stored_.snapshot.experience({0x11});
  EXPECT_EQ(experience.places.size(), 3U);
  EXPECT_EQ(experience.place(2), nullptr);
  EXPECT_EQ(experience.extent, 4U);
  EXPECT_EQ(experience.chain.size(), 1U) << "the edges to it go with it";
  EXPECT_EQ(stored_.snapshot.experience({0x22})->places.size(), 3U);
  EXPECT_EQ(stored_.snapshot.stitch_count(), 1U);
  EXPECT_EQ(stored_.snapshot.labels().size(), 2U);
  EXPECT_TRUE(is_named("place " + to_string(PlaceId{{0x11}, 2})));
  EXPECT_EQ(stored_.quarantined.size(), 1U);
}

TEST_F(SqliteDamage, OfAPlaceWhatWasKnownBeforeIsServedWhenWhatIsKnownNowIsDamaged) {
  const Bytes better(100, 0x41);
  const Place taught = first_.batch.places[1];
  const Place anew = sample::known_anew(taught, better, sample::robot(2));
  ASSERT_TRUE(
      store_->commit({{PutContent{hash_bytes(better), msg::ContentKind::content, better}, PutPlaces{{anew}}}}));
  damage("UPDATE place_anew SET row = substr(row, 1, 30) || x'5a' || substr(row, 32)");
  EXPECT_EQ(*stored_.snapshot.place(taught.id), taught);
  EXPECT_TRUE(is_named("place " + to_string(taught.id) + ", as it is known since revision 4"));
  EXPECT_EQ(stored_.quarantined.size(), 1U);
}

TEST_F(SqliteDamage, WhatHungOnADamagedPlaceIsNamed) {
  damage("UPDATE place SET row = zeroblob(60) WHERE experience = 17 AND place = 3");
  EXPECT_EQ(stored_.snapshot.stitch_count(), 0U);
  EXPECT_EQ(stored_.snapshot.labels().count("near"), 1U);
  EXPECT_EQ(stored_.snapshot.labels().count("far"), 0U);
  EXPECT_TRUE(is_named("label far"));
  EXPECT_TRUE(is_named("stitch " + to_string(PlaceId{{0x11}, 3})));
}

TEST_F(SqliteDamage, MissingLastRowIsNoticed) {
  damage("DELETE FROM place WHERE experience = 34 AND place = 2");
  EXPECT_EQ(stored_.snapshot.experience({0x22})->places.size(), 2U);
  EXPECT_TRUE(is_named("the rows of places 2 are missing"));
}

TEST_F(SqliteDamage, ACountThatIsDamagedMakesNothingLarge) {
  for (const char* const count : {"4294967295", "4294967296", "-1"}) {
    damage(std::string("UPDATE experience SET places = ") + count + " WHERE id = 34");
    const Experience& experience = *stored_.snapshot.experience({0x22});
    EXPECT_EQ(experience.places.size(), 3U);
    EXPECT_EQ(experience.extent, 3U);
    EXPECT_EQ(stored_.snapshot.stitch_count(), 1U);
    EXPECT_EQ(stored_.quarantined.size(), 1U);
  }
  EXPECT_TRUE(is_named("its row says 18446744073709551615 places, which no run has; 3 are there"));
  damage("UPDATE experience SET places = 4000000000 WHERE id = 34");
  EXPECT_TRUE(is_named("the rows of places 3 to 3999999999 are missing"));
  damage("UPDATE experience SET places = 1 WHERE id = 34");
  EXPECT_EQ(stored_.snapshot.experience({0x22})->places.size(), 3U);
  EXPECT_TRUE(is_named("its row says 1 places, 3 are there"));
}

TEST_F(SqliteDamage, RowUnderAnotherKeyIsNotTaken) {
  damage(
      "UPDATE place SET row = (SELECT row FROM place WHERE experience = 17 AND place = 3)"
      " WHERE experience = 17 AND place = 1");
  EXPECT_EQ(stored_.snapshot.experience({0x11})->place(1), nullptr);
  EXPECT_TRUE(is_named("the row of another place"));
}

TEST_F(SqliteDamage, DamagedEdgesAreLeftOut) {
  damage("UPDATE edge SET row = zeroblob(40) WHERE a_experience <> b_experience");
  EXPECT_EQ(stored_.snapshot.place_count(), 7U);
  EXPECT_EQ(stored_.snapshot.stitch_count(), 0U);
  EXPECT_TRUE(is_named("edge " + to_string(PlaceId{{0x11}, 3}) + " - " + to_string(PlaceId{{0x22}, 1})));
  damage("DELETE FROM edge WHERE a_experience = 17 AND a_place = 0");
  EXPECT_EQ(stored_.snapshot.experience({0x11})->places.size(), 4U);
  EXPECT_EQ(stored_.snapshot.experience({0x11})->hop(0), nullptr);
  EXPECT_TRUE(is_named("the rows of the edges after places 0 are missing"));
}

TEST_F(SqliteDamage, DamagedGoalsRoutesAndOccupanciesAreNamed) {
  damage("UPDATE goal SET row = x'01' WHERE id = x'" + to_string(sample::goal_id(1)) + "'");
  damage("UPDATE route SET row = zeroblob(100)");
  damage("UPDATE occupancy SET row = zeroblob(100)");
  EXPECT_EQ(stored_.goals.size(), 1U);
  EXPECT_TRUE(stored_.goals.contains(sample::goal_id(2)));
  EXPECT_TRUE(stored_.routes.empty());
  EXPECT_TRUE(stored_.occupancies.empty());
  EXPECT_TRUE(is_named("goal " + to_string(sample::goal_id(1))));
  EXPECT_TRUE(is_named("route of goal " + to_string(sample::goal_id(1))));
  EXPECT_TRUE(is_named("occupancy of robot " + to_string(sample::robot(1))));
}

}  // namespace
}  // namespace weft::storage
