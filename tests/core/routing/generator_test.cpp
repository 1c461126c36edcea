#include <gtest/gtest.h>

#include "core/network/codec.hpp"
#include "tests/support/site_network.hpp"

namespace weft {
namespace {

TEST(SiteGenerator, MakesBatchesThatFitOneAfterTheOther) {
  SiteGenerator generator({.places = 5'000, .seed = 1, .content_bytes = 100, .batch_places = 300});
  Snapshot snapshot;
  while (!generator.is_done()) {
    const Batch batch = generator.next();
    for (const Error& error : check(snapshot, batch)) ADD_FAILURE() << error.message;
    const Place& place = batch.places.front();
    EXPECT_EQ(hash_bytes(generator.content(place.id)), place.content.hash);
    EXPECT_EQ(generator.content(place.id).size(), 100U);
    snapshot = with(snapshot, batch);
  }
  EXPECT_EQ(snapshot.place_count(), 5'000U);
}

TEST(SiteGenerator, GivesTheSameForTheSameSeedAlone) {
  const auto hashes = [](std::uint64_t seed) {
    SiteGenerator generator({.places = 3'000, .seed = seed});
    std::vector<ContentHash> all;
    while (!generator.is_done()) all.push_back(hash(generator.next()));
    return all;
  };
  EXPECT_EQ(hashes(1), hashes(1));
  EXPECT_NE(hashes(1), hashes(2));
}

TEST(SiteGenerator, HasTheDegreesOfASite) {
  const Snapshot snapshot = support::make_site({.places = 50'000, .seed = 1});
  const auto places = static_cast<double>(snapshot.place_count());
  EXPECT_EQ(snapshot.place_count(), 50'000U);
  EXPECT_NEAR(static_cast<double>(snapshot.stitch_count()) / places, 0.5, 0.05);
  EXPECT_GT(snapshot.labels().size(), 10U);
  for (const auto& [id, experience] : snapshot.experiences()) {
    for (const Edge& edge : experience->stitches) EXPECT_LT(distance_m(edge.a_from_b), 3.0);
  }
}

TEST(SiteGenerator, NamesWhatIsOutOfBounds) {
  EXPECT_TRUE(check(SitePlan{}));
  const Result<void> none = check(SitePlan{.places = 0});
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().message.find("places is 0"), std::string::npos);
  EXPECT_FALSE(check(SitePlan{.content_bytes = 3}));
  EXPECT_FALSE(check(SitePlan{.batch_places = 5000}));
  EXPECT_FALSE(check(SitePlan{.runs_a_corridor = 0}));
}

}  // namespace
}  // namespace weft
