#include "agents/methods/recognition/index.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "core/network/change.hpp"
#include "core/network/search.hpp"
#include "core/random.hpp"

namespace weft::agents {
namespace {

constexpr std::size_t kNumbers = 128;

/// Arranges a site of straight runs whose views change slowly along them, so that neighbours look alike.
class Recognition : public testing::Test {
 protected:
  void run(std::uint64_t experience, std::uint32_t places) {
    Batch batch;
    batch.experience = ExperienceId{experience};
    batch.sequence = 1;
    batch.robot.bytes[0] = 1;
    batch.method = "marks";
    for (std::uint32_t i = 0; i < places; ++i) {
      Place place;
      place.id = {batch.experience, i};
      place.method = "marks";
      place.content.size = 1;
      place.content.hash.bytes[0] = static_cast<std::uint8_t>(1 + i % 200);
      place.robot = batch.robot;
      if (i > 0) {
        Edge edge;
        edge.id = {{batch.experience, i - 1}, place.id};
        edge.a_from_b = Metric2{Pose2{0.2, 0.0, 0.0}, Eigen::Matrix3d::Identity() * 1e-6};
        edge.method = "marks";
        batch.edges.push_back(edge);
      }
      EXPECT_TRUE(index.put(place.id, view(place.id)));
      batch.places.push_back(place);
    }
    snapshot = with(snapshot, batch);
  }

  /// Returns what is seen there: half of it is seen at the place before too.
  static Signature view(const PlaceId& id, std::uint64_t again = 0) {
    Signature seen(kNumbers);
    Random here(id.experience.value * 100'000 + id.index);
    Random before(id.experience.value * 100'000 + id.index - 1);
    Random noise(7 * id.index + again);
    for (float& number : seen)
      number = static_cast<float>(here.normal() + before.normal() + (again > 0 ? 0.5 * noise.normal() : 0.0));
    return seen;
  }

  static std::vector<PlaceId> in_pieces(const RecognitionIndex& index, const Snapshot& snapshot,
                                        const Signature& seen, const Wanted& wanted, std::size_t piece) {
    RecognitionSearch search(index, seen, kept_for(wanted));
    while (search.step(index, snapshot, piece)) {
    }
    return spread_out(snapshot, search.ranked(), wanted);
  }

  RecognitionIndex index;
  Snapshot snapshot;
};

TEST_F(Recognition, ThePlaceThatIsSeenAgainComesFirst) {
  run(1, 700);
  run(2, 300);
  for (const PlaceId& id :
       {PlaceId{ExperienceId{1}, 0}, PlaceId{ExperienceId{1}, 699}, PlaceId{ExperienceId{2}, 150}}) {
    const std::vector<PlaceId> places = likeliest(index, snapshot, view(id, 3), {.most = 10, .after = 0});
    ASSERT_EQ(places.size(), 10U);
    EXPECT_EQ(places.front(), id);
  }
}

TEST_F(Recognition, PiecesGiveWhatOneSearchGives) {
  run(1, 700);
  run(2, 300);
  const Signature seen = view({ExperienceId{2}, 99}, 5);
  EXPECT_EQ(in_pieces(index, snapshot, seen, {}, 1), likeliest(index, snapshot, seen, {}));
}

TEST_F(Recognition, NoMoreThanTwoLieWithinAFewHops) {
  run(1, 400);
  const std::vector<PlaceId> places =
      likeliest(index, snapshot, view({ExperienceId{1}, 200}, 1), {.most = 200, .after = 0});
  EXPECT_GT(places.size(), 90U);
  const std::set<PlaceId> proposed(places.begin(), places.end());
  for (const PlaceId& id : places) {
    std::size_t near = 0;
    for (const PlaceId& other : neighbourhood(snapshot, id, 3, 100)) near += proposed.count(other);
    EXPECT_LE(near, 4U) << to_string(id);  // two to each side at most
  }
}

TEST_F(Recognition, PlacesBehindTheFirstGoOnWhereThoseEnded) {
  run(1, 500);
  const Signature seen = view({ExperienceId{1}, 80}, 1);
  std::vector<PlaceId> paged;
  for (std::size_t after = 0; after < 60; after += 20) {
    const std::vector<PlaceId> page = likeliest(index, snapshot, seen, {.most = 20, .after = after});
    paged.insert(paged.end(), page.begin(), page.end());
  }
  EXPECT_EQ(paged, likeliest(index, snapshot, seen, {.most = 60, .after = 0}));
  EXPECT_TRUE(likeliest(index, snapshot, seen, {.most = 20, .after = 5000}).empty());
}

TEST_F(Recognition, OnlyPlacesOfTheMapAreProposed) {
  run(1, 50);
  const PlaceId there{ExperienceId{1}, 20};
  const Snapshot empty;
  EXPECT_TRUE(likeliest(index, empty, view(there, 1), {}).empty());
  index.forget(ExperienceId{1});
  EXPECT_TRUE(likeliest(index, snapshot, view(there, 1), {}).empty());
}

TEST(RecognitionIndex, CountsWhatItHasAndForgets) {
  RecognitionIndex index;
  const Signature some(kNumbers, 0.5F);
  EXPECT_TRUE(index.put({ExperienceId{1}, 300}, some));
  EXPECT_TRUE(index.put({ExperienceId{1}, 300}, some));
  EXPECT_TRUE(index.put({ExperienceId{2}, 0}, some));
  EXPECT_EQ(index.size(), 2U);
  EXPECT_TRUE(index.has({ExperienceId{1}, 300}));
  EXPECT_FALSE(index.has({ExperienceId{1}, 299}));
  EXPECT_FALSE(index.has({ExperienceId{3}, 0}));
  index.forget(ExperienceId{1});
  EXPECT_EQ(index.size(), 1U);
  index.forget(ExperienceId{2});
  EXPECT_EQ(index.size(), 0U);
  EXPECT_EQ(index.memory_bytes(), 0U);
}

TEST(RecognitionIndex, AMillionSignaturesOfTheFloorFitIn270MB) {
  RecognitionIndex index;
  Signature signature(512);
  for (std::size_t i = 0; i < signature.size(); ++i) signature[i] = static_cast<float>(i % 7);
  for (std::uint32_t i = 0; i < 10'000; ++i)
    ASSERT_TRUE(index.put({ExperienceId{1 + i / 2000}, i % 2000}, signature));
  EXPECT_LT(index.memory_bytes() * 100, 270'000'000U);
}

TEST(RecognitionIndex, TakesNoSignatureThatIsNone) {
  RecognitionIndex index;
  const PlaceId id{ExperienceId{1}, 0};
  EXPECT_FALSE(index.put(id, {}));
  EXPECT_FALSE(index.put(id, Signature(longest_signature + 1, 0.5F)));
  EXPECT_FALSE(index.put(id, Signature(4, std::numeric_limits<float>::quiet_NaN())));
  EXPECT_FALSE(index.put(id, Signature(4, std::numeric_limits<float>::infinity())));
  EXPECT_EQ(index.size(), 0U);
  EXPECT_TRUE(index.put(id, Signature(4, 0.5F)));
  EXPECT_FALSE(index.put({ExperienceId{1}, 1}, Signature(5, 0.5F)));
  EXPECT_FALSE(index.fits(Signature(5, 0.5F)));
  EXPECT_TRUE(index.fits(Signature(4, 0.1F)));
}

}  // namespace
}  // namespace weft::agents
